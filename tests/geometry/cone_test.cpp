#include "geometry/cone.h"

#include <doctest/doctest.h>

using namespace raytree;

namespace {

using V = Vec3<double>;

Ray<double> ray(const V& origin, const V& direction) {
    return {origin, UnitVec3<double>::of(direction).vec(), 0};
}

const auto cylinder = make_cone<double>({0, 0, 0}, 1, {0, 4, 0}, 1);
const auto cone = make_cone<double>({0, 0, 0}, 2, {0, 2, 0}, 0);  // opens by 45 degrees

}  // namespace

TEST_CASE("cone: a cylinder is met on its two sides") {
    const auto roots = intersect(cylinder, ray({5, 1, 0}, {-1, 0, 0}), Start::anywhere);
    REQUIRE(roots.count == 2);
    CHECK(roots.t[0] == doctest::Approx(4).epsilon(1e-15));
    CHECK(roots.t[1] == doctest::Approx(6).epsilon(1e-15));
}

TEST_CASE("cone: both ends are open, and belong to it") {
    CHECK(intersect(cylinder, ray({0, 9, 0}, {0, -1, 0}), Start::anywhere).count == 0);
    CHECK(intersect(cylinder, ray({0.5, 9, 0}, {0, -1, 0}), Start::anywhere).count == 0);
    CHECK(intersect(cylinder, ray({5, 4, 0}, {-1, 0, 0}), Start::anywhere).count == 2);
    CHECK(intersect(cylinder, ray({5, 4.001, 0}, {-1, 0, 0}), Start::anywhere).count == 0);
    // In through the open top, out through the wall: (0.5, 9) to x = 1 at a slope of 1 in 8.
    const auto through = intersect(cylinder, ray({0.5, 6, 0}, {1, -8, 0}), Start::anywhere);
    REQUIRE(through.count == 1);
    CHECK(through.t[0] * 1 / std::sqrt(65.0) == doctest::Approx(0.5));
}

TEST_CASE("cone: a cone's wall leans, its normal too, and the mirror cone is not there") {
    const Ray<double> r = ray({5, 1, 0}, {-1, 0, 0});
    const auto roots = intersect(cone, r, Start::anywhere);
    REQUIRE(roots.count == 2);
    CHECK(roots.t[0] == doctest::Approx(4).epsilon(1e-15));
    const auto at = surface_at(cone, r, roots.t[0]);
    CHECK(at.geometric_normal.vec().x == doctest::Approx(std::sqrt(0.5)));
    CHECK(at.geometric_normal.vec().y == doctest::Approx(std::sqrt(0.5)));
    CHECK(intersect(cone, ray({5, 3, 0}, {-1, 0, 0}), Start::anywhere).count == 0);
}

TEST_CASE("cone: a ray that leaves it meets the other side once") {
    const Ray<double> r{{1, 1, 0}, {-1, 0, 0}, 0};
    const auto roots = intersect(cone, r, Start::on_this_shape);
    REQUIRE(roots.count == 1);
    CHECK(roots.t[0] == doctest::Approx(2).epsilon(1e-15));
    CHECK(intersect(cone, Ray<double>{{1, 1, 0}, {1, 0, 0}, 0}, Start::on_this_shape).count == 0);
}

TEST_CASE("cone: a ray parallel to its wall meets it once") {
    // The wall at x < 0 rises along (1, 1); a ray along it from the inside meets the far wall only.
    const auto roots = intersect(cone, ray({0.5, 0.25, 0}, {1, 1, 0}), Start::anywhere);
    REQUIRE(roots.count == 1);
    CHECK(0.5 + roots.t[0] * std::sqrt(0.5) ==
          doctest::Approx(2 - 0.25 - roots.t[0] * std::sqrt(0.5)));
}

TEST_CASE("cone: from afar it is met as the reference says") {
    const auto exact_cone = make_cone<Quad>({0, 0, 0}, 2, {0, 2, 0}, 0);
    for (double distance = 10; distance < 1e10; distance *= 10) {
        for (double y = 0.05; y < 1.9; y += 0.1) {
            const Ray<double> r = ray({distance, distance / 3, distance / 7},
                                      V(0.3, y, 0.1) - V(distance, distance / 3, distance / 7));
            const Ray<Quad> q{vector_cast<Quad>(r.origin), vector_cast<Quad>(r.direction), 0};
            const auto roots = intersect(cone, r, Start::anywhere);
            const auto exact = intersect(exact_cone, q, Start::anywhere);
            REQUIRE(roots.count == exact.count);
            for (std::size_t k = 0; k < static_cast<std::size_t>(roots.count); ++k) {
                CHECK(static_cast<double>(abs((roots.t[k] - exact.t[k]) / exact.t[k])) < 1e-14);
            }
        }
    }
}
