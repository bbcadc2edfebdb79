#include "geometry/polygon.h"

#include <doctest/doctest.h>

#include <array>
#include <random>
#include <vector>

#include "geometry/triangle.h"

using namespace raytree;

namespace {

using V = Vec3<double>;

PolygonShape<double> polygon(const std::vector<V>& vertices, const std::vector<V>& normals = {}) {
    return make_polygon<double>(vertices, normals);
}

Ray<double> down_at(double x, double y) { return {{x, y, 10}, {0, 0, -1}, 0}; }

bool meets(const PolygonShape<double>& shape, double x, double y) {
    return intersect(shape, down_at(x, y), Start::anywhere).count == 1;
}

// The letter L, counter-clockwise seen from +z.
const std::vector<V> letter_l = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}};

}  // namespace

TEST_CASE("polygon: a concave outline is hit inside and missed in its notch") {
    const auto shape = polygon(letter_l);
    CHECK(meets(shape, 0.5, 2.5));
    CHECK(meets(shape, 1.5, 0.5));
    CHECK_FALSE(meets(shape, 1.5, 2));
    CHECK_FALSE(meets(shape, 2.5, 0.5));
    CHECK_FALSE(meets(shape, -0.1, 0.5));
    const auto roots = intersect(shape, down_at(0.5, 0.5), Start::anywhere);
    REQUIRE(roots.count == 1);
    CHECK(roots.t[0] == 10);
}

TEST_CASE("polygon: rays through vertices and along edges fall in exactly one of two neighbours") {
    const auto left = polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}});
    const auto right = polygon({{1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 2, 0}, {1, 1, 0}});
    for (double y = 0.125; y < 2; y += 0.125) {
        CHECK(meets(left, 1, y) != meets(right, 1, y));
    }
}

TEST_CASE("polygon: the front is the side from which the vertices run counter-clockwise") {
    const auto shape = polygon(letter_l);
    CHECK(shape.plane.normal.vec().z == doctest::Approx(1));
    std::vector<V> reversed(letter_l.rbegin(), letter_l.rend());
    CHECK(polygon(reversed).plane.normal.vec().z == doctest::Approx(-1));
}

TEST_CASE("polygon: parallel rays and rays that leave it do not meet it") {
    const auto shape = polygon(letter_l);
    CHECK(intersect(shape, Ray<double>{{-1, 0.5, 0}, {1, 0, 0}, 0}, Start::anywhere).count == 0);
    CHECK(intersect(shape, down_at(0.5, 0.5), Start::on_this_shape).count == 0);
}

TEST_CASE("polygon: a start on its plane within rounding is not a hit at t = 0") {
    const auto shape = polygon(letter_l);
    const Ray<double> r{{0.5, 0.5, 1e-16}, {0, 0, -1}, 4e-16};
    CHECK(intersect(shape, r, Start::on_another_shape).count == 0);
    const Ray<double> off{{0.5, 0.5, 1e-12}, {0, 0, -1}, 4e-16};
    CHECK(intersect(shape, off, Start::on_another_shape).count == 1);
}

TEST_CASE("polygon: far from the origin its plane keeps its digits") {
    std::vector<V> moved;
    for (const V& v : letter_l) {
        moved.push_back(v + V(1e8, 1e8, 1e8));
    }
    const auto shape = polygon(moved);
    CHECK(shape.plane.normal.vec().x == 0);
    CHECK(shape.plane.normal.vec().z == 1);
    CHECK(meets(shape, 1e8 + 0.5, 1e8 + 2.5) == false);  // it starts below the plane
    CHECK(intersect(shape, Ray<double>{{1e8 + 0.5, 1e8 + 2.5, 1e8 + 1}, {0, 0, -1}, 0},
                    Start::anywhere)
              .count == 1);
}

TEST_CASE("polygon: normals are interpolated along the two edges, then between them") {
    // On the square [0,2]^2 in z = 0 the axes kept are (x, y): the line y = 0.5 meets the edge
    // x = 0 a quarter of the way from (0,0) to (0,2), and x = 2 likewise.
    const V a = UnitVec3<double>::of({0, 0, 1}), b = UnitVec3<double>::of({1, 0, 1});
    const V c = UnitVec3<double>::of({1, 1, 1}), d = UnitVec3<double>::of({0, 1, 1});
    const auto shape = polygon({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}},
                               {3.0 * a, b, 2.0 * c, d});  // of any length: made unit first
    const V left = 0.75 * a + 0.25 * d;
    const V right = 0.75 * b + 0.25 * c;
    const V expected = UnitVec3<double>::of(0.5 * left + 0.5 * right);
    const auto at = surface_at(shape, down_at(1, 0.5), 10.0);
    CHECK(length<double>(at.shading_normal.vec() - expected) < 1e-15);
    CHECK(at.geometric_normal.vec().z == 1);
    CHECK(at.point.z == 0);
}

TEST_CASE("polygon: across a notch the nearest crossings on either side count") {
    // A comb open to the top: the line y = 2 crosses its outline at x = 0, 1, 2 and 3.
    const V up(0, 0, 1), tilted = UnitVec3<double>::of({1, 0, 1});
    const auto comb = polygon(
        {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {2, 3, 0}, {2, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}},
        {up, tilted, tilted, tilted, tilted, up, up, up});
    CHECK(length<double>(interpolated_normal(comb, V(0.5, 2, 0)).vec() - up) < 1e-15);
    CHECK(length<double>(interpolated_normal(comb, V(2.5, 2, 0)).vec() - tilted) < 1e-15);
}

TEST_CASE("triangle: bilinear and barycentric interpolation agree") {
    const std::vector<V> vertices = {{0, 0, 0}, {4, 1, 0.5}, {1, 3, -0.5}};
    const std::vector<V> normals = {UnitVec3<double>::of({0.1, 0, 1}),
                                    UnitVec3<double>::of({0.3, 0.2, 1}),
                                    UnitVec3<double>::of({-0.4, 0.1, 1})};
    const auto bilinear = polygon(vertices, normals);
    const TriangleShape<double> triangle{{vertices[0], vertices[1], vertices[2]}};
    const VertexNormals<double> corner{normals[0], normals[1], normals[2]};
    for (double s = 0.1; s < 0.9; s += 0.2) {
        for (double t = 0.05; s + t < 0.95; t += 0.2) {
            const V p = (1 - s - t) * vertices[0] + s * vertices[1] + t * vertices[2];
            const V difference =
                interpolated_normal(bilinear, p).vec() -
                interpolated_normal(triangle, supporting_plane(triangle).normal, corner, p).vec();
            CHECK(length(difference) < 1e-14);
        }
    }
}

TEST_CASE("triangle: no ray passes between neighbours of a fan, however thin") {
    const V hub(0.1, 0.2, 0.3);
    std::vector<TriangleShape<double>> fan;
    std::vector<V> rim;
    constexpr int count = 40;
    for (int k = 0; k < count; ++k) {
        const double angle = 6.283185307179586 * k / count;
        rim.push_back(hub + V(std::cos(angle), std::sin(angle), 0.2 * std::sin(3 * angle)));
    }
    for (std::size_t k = 0; k < count; ++k) {
        fan.push_back({{hub, rim[k], rim[(k + 1) % count]}});
    }
    const V eye(0.3, -0.2, 7);
    for (std::size_t k = 0; k < count; ++k) {
        for (double s = 0; s < 1; s += 0.03125) {
            const V aim = hub + s * (rim[k] - hub);  // on an edge, as near as a double can be
            const Ray<double> r{eye, UnitVec3<double>::of(aim - eye).vec(), 0};
            int hits = 0;
            for (const auto& triangle : fan) {
                hits += intersect(triangle, r, Start::anywhere).count;
            }
            CHECK(hits >= 1);
        }
    }
}

TEST_CASE("triangle: so far away that its corners are all but one, it is not met far beside it") {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const auto any = [&] { return V(uniform(random), uniform(random), uniform(random)); };
    for (int k = 0; k < 2000; ++k) {
        const V middle = 1e6 * any();
        const TriangleShape<double> small{{middle + 0.1 * any(), middle + 0.1 * any(), middle}};
        const V eye = 1e15 * any();
        const V past = middle + 1e14 * any();
        const Ray<double> ray{eye, UnitVec3<double>::of(past - eye).vec(), 0};
        const V way = middle - eye;
        const double beside = length(outer<double>(ray.direction, way));
        if (beside > 1e12) {
            CHECK(intersect(small, ray, Start::anywhere).count == 0);
        }
    }
}

TEST_CASE("polygon: seen from anywhere, a point of a shared edge is in exactly one of two") {
    // In a slanted plane the two polygons compute their planes, and so t, differently.
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const auto any = [&] {
        return Vec3<double>(uniform(random), uniform(random), uniform(random));
    };
    for (int k = 0; k < 2000; ++k) {
        const Vec3<double> a = any(), u = any(), v = any();
        const Vec3<double> shared[2] = {a, a + u};
        const std::array<Vec3<double>, 4> above{shared[0], shared[1], a + u + v, a + v};
        const std::array<Vec3<double>, 4> below{shared[1], shared[0], a - 1.5 * v, a + u - 0.5 * v};
        const auto one = make_polygon<double>(above, {});
        const auto other = make_polygon<double>(below, {});
        const Vec3<double> eye = a + 5.0 * any();
        const Vec3<double> at = shared[0] + 0.5 * (1 + uniform(random)) * (shared[1] - shared[0]);
        const Ray<double> ray{eye, UnitVec3<double>::of(at - eye).vec()};
        CHECK(intersect(one, ray, Start::anywhere).count +
                  intersect(other, ray, Start::anywhere).count ==
              1);
    }
}
