#include "tree/derivation.h"

#include <doctest/doctest.h>

#include <cmath>

#include "support/scenes.h"
#include "tree/record.h"

using namespace raytree;

namespace {

using doctest::Approx;

TEST_CASE("a sphere met head on: A 1, B -10, C 24, so t is 4 or 6") {
    const Sphere sphere{{0, 0, 0}, 1};
    const SphereDerivation d = derive_sphere(sphere, {{0, 0, 5}, {0, 0, -1}}, 4);
    CHECK(d.a == 1);
    CHECK(d.b == -10);
    CHECK(d.c == 24);
    CHECK(d.discriminant == 4);
    CHECK(d.roots[0] == 4);
    CHECK(d.roots[1] == 6);
    CHECK(d.taken == 0);
}

TEST_CASE("a sphere met from within: the root behind the start is not taken") {
    const SphereDerivation d = derive_sphere({{0, 0, 0}, 3}, {{0, 0, 1}, {0, 0, -1}}, 4);
    CHECK(d.c == -8);
    CHECK(d.roots[0] == -2);
    CHECK(d.roots[1] == 4);
    CHECK(d.taken == 1);
}

TEST_CASE("a polygon: plane, t, the axis dropped and the crossings") {
    // An L in the plane y = 2; the ray comes down at x = 1, z = 3.
    const std::array<Vec3<double>, 6> outline = {
        {{0, 2, 0}, {0, 2, 4}, {4, 2, 4}, {4, 2, 2}, {2, 2, 2}, {2, 2, 0}}};
    const PolygonDerivation d = derive_polygon(outline, {{1, 7, 3}, {0, -1, 0}});
    CHECK(d.normal.y == 1);
    CHECK(d.offset == 2);
    CHECK(d.start == 7);
    CHECK(d.speed == -1);
    CHECK(d.t == 5);
    CHECK(d.dropped == 1);
    CHECK(d.u == 3);  // z, x: in cyclic order
    CHECK(d.v == 1);
    CHECK(d.crossings == 1);
    CHECK(derive_polygon(outline, {{3, 7, 1}, {0, -1, 0}}).crossings % 2 == 0);
}

/// A glass ball of radius 1 at the origin before a matt wall, seen from (0, 0, 5) along -z.
Scene ball_before_wall() {
    Scene scene;
    scene.camera = test::one_pixel_camera();
    Material glass;
    glass.name = "glass";
    glass.ka = glass.kd = Colour(0.0);
    glass.kt = Colour(1.0);
    glass.ior = 1.5;
    Material matt;
    matt.name = "matt";
    scene.materials = {glass, matt};
    scene.objects.push_back({"ball", 0, {}, Sphere{{0, 0, 0}, 1}});
    scene.objects.push_back(
        {"wall", 1, {}, Polygon{{{-9, -9, -3}, {9, -9, -3}, {9, 9, -3}, {-9, 9, -3}}, {}}});
    return scene;
}

TEST_CASE("a cylinder along z: both roots of its circle, and the open end that spares one") {
    const Cone cylinder{{0, 0, 0}, {0, 0, 4}, 1, 1};
    // Across the axis at z = 2: in at x = 1, out at x = -1.
    const ConeDerivation across = derive_cone(cylinder, {{3, 0, 2}, {-1, 0, 0}}, 2);
    CHECK(across.slope == 0);
    CHECK(across.a == Approx(1));
    CHECK(across.b == Approx(-6));
    CHECK(across.c == Approx(8));
    CHECK(across.discriminant == Approx(4));
    CHECK(across.roots[0] == Approx(2));
    CHECK(across.roots[1] == Approx(4));
    CHECK(across.heights[0] == Approx(2));
    CHECK(across.taken == 0);
    // From beyond the open end at 45 degrees: the first root lies above the cylinder.
    const double s = std::sqrt(0.5);
    const ConeDerivation slanted = derive_cone(cylinder, {{1.5, 0, 5}, {-s, 0, -s}}, 2.5 / s);
    CHECK(slanted.heights[0] == Approx(4.5));
    CHECK(slanted.heights[0] > slanted.height);
    CHECK(slanted.heights[1] == Approx(2.5));
    CHECK(slanted.taken == 1);
}

TEST_CASE(
    "a cone with a half right angle: roots where |y| is 2 - x, and none of them a mirror image") {
    const Cone cone{{0, 0, 0}, {2, 0, 0}, 2, 0};
    // Level with y = 1, against x: it meets the surface at x = 1.
    const ConeDerivation d = derive_cone(cone, {{5, 1, 0}, {-1, 0, 0}}, 4);
    CHECK(d.slope == Approx(-1));
    CHECK(d.height == Approx(2));
    CHECK(d.a == Approx(-1));
    CHECK(d.roots[0] == Approx(2));
    CHECK(d.heights[0] == Approx(3));  // on the cone beyond its tip
    CHECK(d.roots[1] == Approx(4));
    CHECK(d.heights[1] == Approx(1));
    CHECK(d.taken == 1);
    // Parallel to a line of the cone there is one root alone.
    const double s = std::sqrt(0.5);
    const ConeDerivation along = derive_cone(cone, {{0, 1, 0}, {s, -s, 0}}, 0);
    CHECK(std::isfinite(along.roots[0]));
}

TEST_CASE("along the way through a ball: what is met, what is taken, and the media") {
    const Scene scene = ball_before_wall();
    const World<double> world(scene);
    const auto tree = record_tree(world, 0, 0);
    REQUIRE(tree.rays.size() >= 3);

    const Derivation first = derive(world, tree, 0);
    REQUIRE(first.along.size() == 3);
    CHECK(first.along[0].object == "ball");
    CHECK(first.along[0].t == Approx(4));
    CHECK(first.along[0].taken);
    CHECK(first.along[1].t == Approx(6));
    CHECK_FALSE(first.along[1].taken);
    CHECK(first.along[2].object == "wall");
    CHECK(first.along[2].t == Approx(8));
    CHECK(first.media.empty());

    const Derivation inside = derive(world, tree, 1);
    REQUIRE(tree.rays[1].kind == RayKind::refracted);
    CHECK(inside.starts_on_it);
    REQUIRE(inside.media.size() == 1);
    CHECK(inside.media[0].material == "glass");
    CHECK(inside.media[0].ior == 1.5);
    const auto& sphere = std::get<SphereDerivation>(inside.how);
    CHECK(sphere.roots[0] == Approx(0));
    CHECK(sphere.roots[1] == Approx(2));
    CHECK(sphere.taken == 1);

    const Derivation beyond = derive(world, tree, 2);
    CHECK(beyond.media.empty());
    CHECK(std::get<PolygonDerivation>(beyond.how).t == Approx(2));
}

TEST_CASE("a transformed sphere is derived in its own space, with t in the world") {
    Scene scene = ball_before_wall();
    scene.objects[0].transform = Affine{};
    for (std::size_t k = 0; k < 3; ++k) {
        scene.objects[0].transform->at(k)[k] = 2;
    }
    const World<double> world(scene);
    const auto tree = record_tree(world, 0, 0);
    const Derivation d = derive(world, tree, 0);
    CHECK(d.own_space);
    CHECK(std::get<SphereDerivation>(d.how).a == Approx(0.25));
    CHECK(std::get<SphereDerivation>(d.how).roots[0] == Approx(3));
}

}  // namespace
