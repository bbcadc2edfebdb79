#include <doctest/doctest.h>

#include <string>

#include "scene/input_error.h"
#include "support/scenes.h"
#include "trace/render.h"
#include "tree/record.h"

using namespace raytree;

namespace {

Scene scene_with(Shape shape) {
    Scene scene;
    test::add_material(scene, {});
    scene.camera = test::one_pixel_camera();
    test::add(scene, std::move(shape));
    return scene;
}

template <class T> std::string refusal(const Scene& scene) {
    try {
        const World<T> world(scene);
        return record_tree(world, 0, 0).rays[0].hit ? "hit" : "no hit";
    } catch (const InputError& error) {
        return error.what();
    }
}

bool mentions(const std::string& text, const char* word) {
    return text.find(word) != std::string::npos && text.find("precision") != std::string::npos;
}

}  // namespace

// All of these passed silently before, with a wrong answer, a NaN or a walk off the hierarchy.

TEST_CASE("range: lengths whose squares overflow are refused, not missed") {
    const double far = 1e200;
    CHECK(mentions(refusal<double>(scene_with(Cone{{0, 0, -far}, {0, 0, far}, far, far / 2})),
                   "too large"));
    CHECK(mentions(refusal<double>(scene_with(Polygon{
                       {{-far, -far, 0}, {far, -far, 0}, {far, far, 0}, {-far, far, 0}}, {}})),
                   "too large"));
    CHECK(mentions(refusal<double>(scene_with(Sphere{{0, 0, 0}, 1e-300})), "too small"));
}

TEST_CASE("range: lengths far apart but in range are met") {
    CHECK(refusal<double>(scene_with(Sphere{{0, 0, -1e100}, 1e99})) == "hit");
    CHECK(refusal<double>(scene_with(
              Polygon{{{-1e100, -1e100, 0}, {1e100, -1e100, 0}, {0, 1e100, 0}}, {}})) == "hit");
}

TEST_CASE("range: what float cannot hold is refused in float alone") {
    const Scene scene = scene_with(Sphere{{0, 0, -1e25}, 1e25});
    CHECK(refusal<double>(scene) == "hit");
    CHECK(mentions(refusal<float>(scene), "too large"));
}

TEST_CASE("range: transforms of tiny and of huge factors keep their inverse") {
    Scene scene = scene_with(Sphere{{0, 0, 0}, 1});
    const double s = 1e-60;
    scene.objects[0].transform = {{{s, 0, 0, 0}, {0, s, 0, 0}, {0, 0, s, 0}}};
    scene.camera.eye = {0, 0, 5 * s};
    CHECK(refusal<double>(scene) == "hit");
    scene.objects[0].transform = {{{1e-120, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
    CHECK(mentions(refusal<double>(scene), "transform"));
}

TEST_CASE("range: refractive indices beyond all ratios are refused") {
    Scene scene = scene_with(Sphere{{0, 0, 0}, 1});
    scene.materials[0].kt = Colour(1.0);
    scene.materials[0].ior = 1e-200;
    CHECK(mentions(refusal<double>(scene), "ior"));
}
