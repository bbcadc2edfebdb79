#include "tree/tree_cast.h"

#include <doctest/doctest.h>

#include "support/scenes.h"
#include "tree/record.h"

namespace raytree {
namespace {

/// A ball of glass over a pane that blocks the light of one lamp.
Scene glass_and_pane() {
    Scene scene;
    scene.camera = test::one_pixel_camera();
    Material glass;
    glass.kr = Colour(0.2);
    glass.kt = Colour(0.7);
    test::add(scene, Sphere{{0.1, 0.2, 0}, 1}, test::add_material(scene, glass));
    test::add(scene, Polygon{{{-9, -9, -3}, {9, -9, -3}, {9, 9, -3}, {-9, 9, -3}}, {}});
    scene.lights.resize(2);
    scene.lights[0].name = "behind";
    scene.lights[0].kind = PointLight{{3, 2, -5}, {}};
    scene.lights[1].name = "sun";
    scene.lights[1].kind = DirectionalLight{{0.1, -1, -1}};
    return scene;
}

}  // namespace

TEST_CASE("tree_cast: there and back in a wider arithmetic changes nothing") {
    const Scene scene = glass_and_pane();
    const World<double> world(scene);
    RayTree<double> tree = record_tree(world, 0, 0);
    tree.scene_sha256 = "abc";
    const RayTree<double> back = tree_cast<double>(tree_cast<Quad>(tree));
    REQUIRE(back.rays.size() == tree.rays.size());
    CHECK(tree.counts.refracted > 0);
    CHECK(tree.counts.shadow > 0);
    CHECK(back.scene_sha256 == "abc");
    CHECK(back.intensity == tree.intensity);
    CHECK(back.counts.all() == tree.counts.all());
    for (std::size_t k = 0; k < tree.rays.size(); ++k) {
        const TreeRay<double>& a = tree.rays[k];
        const TreeRay<double>& b = back.rays[k];
        CHECK(a.direction == b.direction);
        CHECK(a.intensity == b.intensity);
        CHECK(a.termination == b.termination);
        CHECK(a.skipped.size() == b.skipped.size());
        REQUIRE(a.hit.has_value() == b.hit.has_value());
        REQUIRE(a.shadow.has_value() == b.shadow.has_value());
        if (a.hit) {
            CHECK(a.hit->point == b.hit->point);
            CHECK(a.hit->kt == b.hit->kt);
            CHECK(a.hit->interface.has_value() == b.hit->interface.has_value());
        }
        if (a.shadow) {
            CHECK(a.shadow->distance == b.shadow->distance);
            CHECK(a.shadow->blocked_by.has_value() == b.shadow->blocked_by.has_value());
        }
    }
}

}  // namespace raytree
