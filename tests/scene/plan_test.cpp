#include "scene/plan.h"

#include <doctest/doctest.h>

#include "support/scenes.h"

namespace raytree {
namespace {

/// Kinds of shapes and lights, all of one matt material.
Scene matt_scene() {
    Scene scene;
    test::add_material(scene, {});
    test::add(scene, Sphere{});
    test::add(scene, Polygon{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}});
    test::add(scene, Cone{});
    scene.lights.resize(3);
    scene.lights[2].kind = DirectionalLight{};
    return scene;
}

Mesh triangle_mesh(int normal) {
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.normals = {{0, 0, 1}};
    mesh.triangles = {{{{0, normal}, {1, normal}, {2, normal}}}};
    return mesh;
}

}  // namespace

TEST_CASE("plan: shapes, lights and materials are counted by kind") {
    Scene scene = matt_scene();
    test::add(scene, triangle_mesh(-1));
    test::add_material(scene, {});
    const Plan plan = plan_of(scene);
    CHECK(plan.spheres == 1);
    CHECK(plan.polygons == 1);
    CHECK(plan.cones == 1);
    CHECK(plan.meshes == 1);
    CHECK(plan.triangles == 1);
    CHECK(plan.shapes() == 4);
    CHECK(plan.point_lights == 2);
    CHECK(plan.directional_lights == 1);
    CHECK(plan.materials == 1);
}

TEST_CASE("plan: a matt scene takes light and shadows and nothing else") {
    const Plan plan = plan_of(matt_scene());
    CHECK(plan.lit);
    CHECK(plan.shadow_rays);
    CHECK_FALSE(plan.specular);
    CHECK_FALSE(plan.branches());
    CHECK_FALSE(plan.shadows_through);
    CHECK_FALSE(plan.light_attenuated);
    CHECK_FALSE(plan.attenuated);
    CHECK_FALSE(plan.interpolated_normals);
    CHECK_FALSE(plan.transforms);
    CHECK_FALSE(plan.near_plane);
    CHECK_FALSE(plan.path_limited);
}

TEST_CASE("plan: only materials that an object has count") {
    Scene scene = matt_scene();
    Material glass;
    glass.ks = glass.kr = glass.kt = Colour(0.5);
    const std::size_t place = test::add_material(scene, glass);
    CHECK_FALSE(plan_of(scene).branches());
    scene.objects[1].material = place;
    const Plan plan = plan_of(scene);
    CHECK(plan.reflective);
    CHECK(plan.transmissive);
    CHECK(plan.specular);
    CHECK(plan.materials == 2);
}

TEST_CASE("plan: without a light, or with nothing to light, there are no shadow rays") {
    Scene dark = matt_scene();
    dark.lights.clear();
    CHECK_FALSE(plan_of(dark).lit);
    CHECK_FALSE(plan_of(dark).shadow_rays);
    Scene black = matt_scene();
    black.materials[0].kd = Colour(0.0);
    CHECK_FALSE(plan_of(black).lit);
    Scene shadowless = matt_scene();
    shadowless.settings.shadows = ShadowMode::none;
    CHECK(plan_of(shadowless).lit);
    CHECK_FALSE(plan_of(shadowless).shadow_rays);
}

TEST_CASE("plan: each setting counts where something feels it") {
    Scene scene = matt_scene();
    scene.settings.shadows = ShadowMode::transmissive;
    scene.settings.attenuation = {1, 0.1, 0};
    CHECK_FALSE(plan_of(scene).shadows_through);
    CHECK_FALSE(plan_of(scene).attenuated);
    scene.materials[0].kt = Colour(0.5);
    CHECK(plan_of(scene).shadows_through);
    CHECK(plan_of(scene).attenuated);
    scene.lights[1].kind = PointLight{{0, 0, 0}, {1, 0, 2}};
    CHECK(plan_of(scene).light_attenuated);
    scene.camera.near = 0.5;
    scene.settings.max_distance = 7;
    scene.objects[0].transform = Affine{};
    CHECK(plan_of(scene).near_plane);
    CHECK(plan_of(scene).path_limited);
    CHECK(plan_of(scene).transforms);
}

TEST_CASE("plan: normals are interpolated where vertices have them and they are used") {
    Scene scene = matt_scene();
    Object& object = test::add(scene, triangle_mesh(0));
    CHECK(plan_of(scene).interpolated_normals);
    std::get<Mesh>(object.shape).smooth = false;
    CHECK_FALSE(plan_of(scene).interpolated_normals);
    std::get<Polygon>(scene.objects[1].shape).normals.assign(3, {0, 0, 1});
    CHECK(plan_of(scene).interpolated_normals);
}

TEST_CASE("plan: a full tree of n levels under m lights has (m + 1)(2^n - 1) rays") {
    Scene scene = matt_scene();
    scene.settings.max_depth = 5;
    CHECK(full_tree_rays(scene) == 4 * 31);
    scene.lights.clear();
    scene.settings.max_depth = 1;
    CHECK(full_tree_rays(scene) == 1);
}

}  // namespace raytree
