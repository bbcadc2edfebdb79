#include "tree/crossing_walk.h"

#include <doctest/doctest.h>

#include "formats/scene_json.h"
#include "tree/record.h"

namespace raytree {
namespace {

/// A comb of three teeth in the plane z = 0, seen straight from z = 5, before a wall at z = -1.
constexpr const char* comb_text = R"({
  "format": "raytree-scene/1.0",
  "camera": {"eye": [0, 0, 5], "look_at": [0, 0, 0], "horizontal_fov_degrees": 60,
             "width": 8, "height": 8},
  "materials": {"grey": {}},
  "lights": [],
  "objects": [
    {"name": "ball", "type": "sphere", "center": [40, 0, 0], "radius": 1, "material": "grey"},
    {"name": "comb", "type": "polygon", "material": "grey", TRANSFORM
     "vertices": [[-3, -2, 0], [3, -2, 0], [3, 2, 0], [2, 2, 0], [2, 0, 0], [1, 0, 0], [1, 2, 0],
                  [-1, 2, 0], [-1, 0, 0], [-2, 0, 0], [-2, 2, 0], [-3, 2, 0]]},
    {"name": "wall", "type": "polygon", "material": "grey",
     "vertices": [[-9, -9, -1], [9, -9, -1], [9, 9, -1], [-9, 9, -1]]}]})";

Scene comb(const std::string& transform = "") {
    std::string text = comb_text;
    text.replace(text.find("TRANSFORM"), 9, transform);
    std::vector<std::string> warnings;
    return read_scene_json(text, "comb.json", warnings);
}

/// A ray from (x, y, 5) straight down the z axis, as a tree would have it.
TreeRay<double> down(double x, double y) {
    TreeRay<double> ray;
    ray.origin = {x, y, 5};
    ray.direction = {0, 0, -1};
    return ray;
}

TEST_CASE("the crossing walk of a comb counts the edges to the right") {
    const Scene scene = comb();
    const World<double> world(scene);
    // In the left tooth, at half its height: out of it, into the middle one and out, and once more.
    const auto left = crossing_walk(world, down(-2.5, 1), "comb");
    REQUIRE(left);
    CHECK(left->inside());
    CHECK(left->test.t == doctest::Approx(5));
    REQUIRE(left->crossed.size() == 5);
    const double at[] = {-2, -1, 1, 2, 3};
    const std::size_t edges[] = {9, 7, 5, 3, 1};
    for (std::size_t k = 0; k < 5; ++k) {
        CHECK(left->crossed[k].u == doctest::Approx(at[k]));
        CHECK(left->crossed[k].at == Vec3<double>(at[k], 1, 0));
        CHECK(left->crossed[k].edge == edges[k]);
    }
    CHECK(left->crossed[0].from == Vec3<double>(-2, 0, 0));
    CHECK(left->crossed[0].to == Vec3<double>(-2, 2, 0));
    const auto gap = crossing_walk(world, down(-1.5, 1), "comb");
    REQUIRE(gap);
    CHECK_FALSE(gap->inside());
    CHECK(gap->crossed.size() == 4);
    CHECK(crossing_walk(world, down(5, 1), "comb")->crossed.empty());
}

TEST_CASE("the crossing walk agrees with what the tracer hits") {
    const Scene scene = comb();
    const World<double> world(scene);
    for (double x = -3.95; x < 4; x += 0.1) {
        for (double y = -2.95; y < 3; y += 0.1) {
            const TreeRay<double> ray = down(x, y);
            NoTestCount count;
            const auto hits = world.shapes.all({ray.origin, ray.direction, 0}, no_primitive,
                                               Interval<double>(), count);
            const bool hit = !hits.empty() && hits.front().t < 5.5;
            CHECK(crossing_walk(world, ray, "comb")->inside() == hit);
        }
    }
}

TEST_CASE(
    "the crossing walk without a name is that of the polygon hit, or of the plane met first") {
    const Scene scene = comb();
    const World<double> world(scene);
    const RayTree<double> tree = record_tree(world, 4, 4);
    REQUIRE(tree.rays[0].hit);
    CHECK(crossing_walk(world, tree.rays[0])->object == tree.rays[0].hit->object);
    TreeRay<double> ray = down(-1.5, 1);
    CHECK(crossing_walk(world, ray)->object == "comb");
    ray.origin.z = -0.5;
    CHECK(crossing_walk(world, ray)->object == "wall");
    ray.origin.z = -2;  // both planes lie behind
    CHECK_FALSE(crossing_walk(world, ray));
    ray.direction = {1, 0, 0};  // parallel
    CHECK_FALSE(crossing_walk(world, ray));
    CHECK_FALSE(crossing_walk(world, down(0, 0), "ball"));
    CHECK_FALSE(crossing_walk(world, down(0, 0), "nobody"));
    CHECK(has_polygon(world, "comb"));
    CHECK_FALSE(has_polygon(world, "ball"));
}

TEST_CASE("the crossing walk of a transformed polygon lies in the world where the polygon does") {
    // Twice as large and moved by (1, 2, 0).
    const Scene scene = comb(R"("transform": [[2, 0, 0, 1], [0, 2, 0, 2], [0, 0, 1, 0],
                                       [0, 0, 0, 1]],)");
    const World<double> world(scene);
    const auto walk = crossing_walk(world, down(-4, 4), "comb");
    REQUIRE(walk);
    CHECK(walk->own_space);
    CHECK(walk->test.u == doctest::Approx(-2.5));
    REQUIRE(walk->crossed.size() == 5);
    CHECK(walk->crossed[0].u == doctest::Approx(-2));
    CHECK(walk->crossed[0].at.x == doctest::Approx(-3));
    CHECK(walk->crossed[0].at.y == doctest::Approx(4));
    CHECK(walk->point == Vec3<double>(-4, 4, 0));
}

}  // namespace
}  // namespace raytree
