#include "app/scenes.h"

#include <unistd.h>

#include "state/commands.h"
#include "support/scenes.h"

namespace raytree::inspector::test {

using raytree::test::add;
using raytree::test::add_material;

Scene deep_scene() {
    Scene scene;
    scene.camera.eye = {0, 0, 9};
    scene.camera.look_at = {0, 0, 0};
    scene.camera.window = HorizontalFov{20};
    scene.camera.width = scene.camera.height = 9;
    scene.settings.max_depth = 23;
    scene.settings.min_weight = 0;
    Material glass;
    glass.name = "glass";
    glass.kr = glass.kt = Colour(0.5);
    glass.ior = 1.1;
    Material mirror;
    mirror.name = "mirror";
    mirror.kr = Colour(0.5);
    add_material(scene, glass);
    add_material(scene, mirror);
    add(scene, Sphere{{0, 0, 0}, 6}, 0).name = "ball";
    add(scene, Sphere{{0, 0, 0}, 10}, 1).name = "room";
    return scene;
}

std::filesystem::path own_path(const std::string& name) {
    return std::filesystem::temp_directory_path() / (std::to_string(getpid()) + '-' + name);
}

Scene glass_ball_scene() {
    Scene scene;
    scene.name = "test";
    scene.camera.eye = {0, 1.5, 6};
    scene.camera.look_at = {0, 0.9, 0};
    scene.camera.width = 80;
    scene.camera.height = 60;
    scene.background = {0.2, 0.3, 0.5};
    scene.settings.max_depth = 4;
    Material glass;
    glass.name = "glass";
    glass.kd = Colour(0.1);
    glass.ks = Colour(0.5);
    glass.kr = Colour(0.1);
    glass.kt = Colour(0.8);
    Material matt;
    matt.name = "matt";
    Material mirror;
    mirror.name = "mirror";
    mirror.kd = Colour(0.0);
    mirror.kr = Colour(0.9);
    for (const Material& material : {glass, matt, mirror}) {
        add_material(scene, material);
    }
    add(scene, Sphere{{0, 1, 0}, 1}, 0).name = "ball";
    add(scene, Polygon{{{-20, 0, 20}, {20, 0, 20}, {20, 0, -20}, {-20, 0, -20}}, {}}, 1).name =
        "floor";
    add(scene, Polygon{{{-2, 0, -3}, {2, 0, -3}, {2, 3, -3}, {-2, 3, -3}}, {}}, 2).name = "mirror";
    scene.lights.push_back({"key", Colour(1.0), PointLight{{3, 6, 4}, {}}});
    scene.lights.push_back({"sun", Colour(0.4), DirectionalLight{{0, -1, 0}}});
    return scene;
}

std::shared_ptr<const Document> document_of(Scene scene) {
    LoadedScene loaded;
    loaded.scene = std::move(scene);
    return std::make_shared<Document>("test.json", std::move(loaded));
}

Opened opened(Scene scene) { return {document_of(std::move(scene)), std::nullopt, {}}; }

void run_and_wait(State& state, std::string_view id, std::string_view argument) {
    run_command(state, id, argument);
    for (int k = 0; k < 600 && state.working(); ++k) {
        state.poll(std::chrono::milliseconds(100));
    }
}

}  // namespace raytree::inspector::test
