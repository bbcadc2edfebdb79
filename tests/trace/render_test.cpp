#include "trace/render.h"

#include <doctest/doctest.h>

#include "scene/plan.h"
#include "support/scenes.h"
#include "trace/tracer.h"
#include "tree/record.h"

using namespace raytree;

namespace {

/// Shapes of all kinds between two lights, with what the plan asks about or without it.
struct Wanted {
    bool reflective, transmissive, attenuated, transforms, normals;
};

Scene scene_with(const Wanted& wanted) {
    Scene scene = test::random_shapes(60, 5, 1, Point(0.0));
    scene.camera = test::one_pixel_camera();
    scene.camera.eye = {0.2, 0.1, 4};
    scene.camera.window = HorizontalFov{50};
    scene.camera.width = 21;
    scene.camera.height = 18;
    scene.lights.push_back({"near", Colour(0.9), PointLight{{1, 2, 3}, {}}});
    scene.lights.push_back({"far", Colour(0.4), DirectionalLight{{0.3, -1, -0.5}}});
    scene.background = {0.1, 0.2, 0.4};
    scene.settings.max_depth = 4;
    scene.settings.min_weight = 0;
    if (wanted.attenuated) {
        scene.settings.attenuation = {1, 0.1, 0.02};
    }
    Material glass;
    glass.name = "glass";
    glass.ks = Colour(0.3);
    glass.kr = Colour(wanted.reflective ? 0.4 : 0);
    glass.kt = Colour(wanted.transmissive ? 0.5 : 0);
    const std::size_t material = test::add_material(scene, glass);
    for (std::size_t k = 0; k < scene.objects.size(); ++k) {
        Object& object = scene.objects[k];
        object.material = k % 3 == 0 ? material : 0;
        if (!wanted.transforms) {
            object.transform.reset();
        }
    }
    Polygon floor{{{-3, -1, -3}, {0, -1, 3}, {3, -1, -3}}, {}};
    if (wanted.normals) {
        floor.normals = {{0.2, 1, 0}, {0, 1, 0.2}, {-0.2, 1, 0}};
    }
    test::add(scene, floor, material);
    return scene;
}

template <class T> void check_picture(const Scene& scene) {
    const World<T> world(scene);
    const Picture picture = render(world, {.threads = 3, .progress = {}});
    CountingRecorder<T> recorder;
    Tracer<T, CountingRecorder<T>> tracer(world, recorder);
    std::size_t differ = 0;
    for (int j = 0; j < picture.height; ++j) {
        for (int i = 0; i < picture.width; ++i) {
            differ += picture.at(i, j) == rgb_cast<double>(tracer.trace_pixel(i, j)) ? 0 : 1;
        }
    }
    CHECK(differ == 0);
}

}  // namespace

TEST_CASE("render: whatever the plan leaves out, pictures are what the trees say") {
    for (unsigned k = 0; k < 32; ++k) {
        CAPTURE(k);
        const Wanted wanted{(k & 1) != 0, (k & 2) != 0, (k & 4) != 0, (k & 8) != 0, (k & 16) != 0};
        const Scene scene = scene_with(wanted);
        const Plan plan = plan_of(scene);
        CHECK(plan.reflective == wanted.reflective);
        CHECK(plan.transmissive == wanted.transmissive);
        CHECK(plan.attenuated == (wanted.attenuated && plan.branches()));
        CHECK(plan.transforms == wanted.transforms);
        CHECK(plan.interpolated_normals == wanted.normals);
        check_picture<double>(scene);
    }
}

TEST_CASE("render: in other arithmetics and with other shadows too") {
    Scene scene = scene_with({true, true, true, true, true});
    check_picture<float>(scene);
    for (const ShadowMode mode : {ShadowMode::none, ShadowMode::opaque, ShadowMode::transmissive}) {
        scene.settings.shadows = mode;
        check_picture<double>(scene);
    }
    scene.lights.clear();
    check_picture<double>(scene);
}

TEST_CASE("render: no number of a pixel's tree depends on which part of a hierarchy is built") {
    Scene scene = scene_with({true, true, false, true, false});
    for (const Object& object : test::random_shapes(11'000, 6, 3, Point(0.0)).objects) {
        scene.objects.push_back(object);
    }
    scene.settings.max_depth = 3;
    const World<double> whole(scene), growing(scene, Build::where_rays_go);
    for (int k = 0; k < 10; ++k) {
        const auto a = record_tree(whole, 2 * k, k), b = record_tree(growing, 2 * k, k);
        REQUIRE(a.rays.size() == b.rays.size());
        CHECK(a.intensity == b.intensity);
        for (std::size_t ray = 0; ray < a.rays.size(); ++ray) {
            REQUIRE(a.rays[ray].hit.has_value() == b.rays[ray].hit.has_value());
            if (a.rays[ray].hit) {
                CHECK(a.rays[ray].hit->t == b.rays[ray].hit->t);
                CHECK(a.rays[ray].hit->object == b.rays[ray].hit->object);
            }
        }
    }
}
