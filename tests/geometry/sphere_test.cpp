#include "geometry/sphere.h"

#include <doctest/doctest.h>

#include <random>

using namespace raytree;

namespace {

const SphereShape<double> unit_sphere{{0, 0, 0}, 1};

Ray<double> ray(const Vec3<double>& origin, const Vec3<double>& direction) {
    return {origin, UnitVec3<double>::of(direction).vec(), 0};
}

}  // namespace

TEST_CASE("sphere: from outside both roots, from inside the one ahead, behind the eye none") {
    const auto outside = intersect(unit_sphere, ray({0, 0, 5}, {0, 0, -1}), Start::anywhere);
    REQUIRE(outside.count == 2);
    CHECK(outside.t[0] == 4);
    CHECK(outside.t[1] == 6);

    const auto within = intersect(unit_sphere, ray({0, 0, 0.5}, {0, 0, -1}), Start::anywhere);
    REQUIRE(within.count == 1);
    CHECK(within.t[0] == 1.5);

    CHECK(intersect(unit_sphere, ray({0, 0, 5}, {0, 0, 1}), Start::anywhere).count == 0);
    CHECK(intersect(unit_sphere, ray({0, 1.001, 5}, {0, 0, -1}), Start::anywhere).count == 0);
}

TEST_CASE("sphere: a tangent ray has one root") {
    const auto roots = intersect(unit_sphere, ray({0, 1, 5}, {0, 0, -1}), Start::anywhere);
    REQUIRE(roots.count == 1);
    CHECK(roots.t[0] == 5);
}

TEST_CASE("sphere: an eye exactly on it does not see that point") {
    const auto inwards = intersect(unit_sphere, ray({0, 0, 1}, {0, 0, -1}), Start::anywhere);
    REQUIRE(inwards.count == 1);
    CHECK(inwards.t[0] == 2);
    CHECK(intersect(unit_sphere, ray({0, 0, 1}, {0, 0, 1}), Start::anywhere).count == 0);
}

TEST_CASE("sphere: a ray that leaves it meets only its other root") {
    const Vec3<double> start = UnitVec3<double>::of({1, 2, 3}).vec();
    CHECK(intersect(unit_sphere, ray(start, start), Start::on_this_shape).count == 0);
    const auto through = intersect(unit_sphere, ray(start, -start), Start::on_this_shape);
    REQUIRE(through.count == 1);
    CHECK(through.t[0] == doctest::Approx(2).epsilon(1e-15));
}

TEST_CASE("sphere: another sphere on the same surface is not met at t = 0") {
    const Vec3<double> start = UnitVec3<double>::of({1, 2, 3}).vec();
    Ray<double> inwards = ray(start, -start);
    inwards.origin_error = 4e-16;
    CHECK(intersect(unit_sphere, inwards, Start::on_another_shape).count == 1);
    CHECK(intersect(unit_sphere, Ray<double>{start, start, 4e-16}, Start::on_another_shape).count ==
          0);
}

TEST_CASE("sphere: seen from 10^12 radii away, t is right to the last digits") {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> uniform(-0.9, 0.9);
    for (double distance = 10; distance <= 1e12; distance *= 10) {
        for (int k = 0; k < 1000; ++k) {
            const Vec3<double> eye(0, 0, distance);
            const Vec3<double> aim(uniform(random) * 0.7, uniform(random) * 0.7, uniform(random));
            const Ray<double> r = ray(eye, aim - eye);
            const Ray<Quad> exact_ray{vector_cast<Quad>(r.origin), vector_cast<Quad>(r.direction),
                                      0};
            const auto roots = intersect(unit_sphere, r, Start::anywhere);
            const auto exact =
                intersect(SphereShape<Quad>{{0, 0, 0}, 1}, exact_ray, Start::anywhere);
            REQUIRE(roots.count == exact.count);
            if (exact.count == 2) {
                const auto error = static_cast<double>(abs((roots.t[0] - exact.t[0]) / exact.t[0]));
                CHECK(error < 2e-15);
            }
        }
    }
}

TEST_CASE("sphere: the hit point lies on it and the normal points outwards") {
    const SphereShape<double> sphere{{1e6, -2e6, 5}, 0.25};
    const Ray<double> r = ray({0, 0, 0}, {1e6 + 0.1, -2e6, 5});
    const auto roots = intersect(sphere, r, Start::anywhere);
    REQUIRE(roots.count == 2);
    const auto at = surface_at(sphere, r, roots.t[0]);
    CHECK(length<double>(at.point - sphere.center) == doctest::Approx(0.25).epsilon(1e-8));
    CHECK(inner(at.geometric_normal, r.direction) < 0);
}
