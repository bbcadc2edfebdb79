#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "app/scenes.h"
#include "state/commands.h"
#include "tree/record.h"

namespace raytree::inspector {
namespace {

namespace fs = std::filesystem;

State glass_ball_state() {
    State state;
    state.show(test::opened(test::glass_ball_scene()));
    return state;
}

const Scene& scene_of(const State& state) { return state.document()->scene(); }

std::string refused(State& state, const std::string& argument) {
    try {
        test::run_and_wait(state, "change.set", argument);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

/// The message that a file with this value gets.
std::string file_message(const std::string& settings) {
    const fs::path file = test::own_path("raytree-change-test.json");
    std::ofstream(file) << R"({"format": "raytree-scene/1.0", "camera": {"eye": [0, 0, 5],
        "look_at": [0, 0, 0], "horizontal_fov_degrees": 50, "width": 4, "height": 4}, "objects": [], "settings": )"
                        << settings << "}";
    std::string message;
    try {
        load_scene(file);
    } catch (const InputError& error) {
        message = error.mistakes().front().place + ": " + error.mistakes().front().text;
    }
    fs::remove(file);
    return message;
}

TEST_CASE("app: a changed value changes the tree as the tracer would") {
    State state = glass_ball_state();
    state.pick({40, 30});
    test::run_and_wait(state, "change.set", "/settings/max_depth 2");
    CHECK(scene_of(state).settings.max_depth == 2);
    Scene scene = test::glass_ball_scene();
    scene.settings.max_depth = 2;
    const auto truth = record_tree(World<double>(scene), 40, 30);
    CHECK(state.tree()->own() == truth.rays.size());
    CHECK(state.tree()->tree.intensity == truth.intensity);
    CHECK(state.pixel() == Pixel{40, 30});
}

TEST_CASE("app: a material is changed whose name has blanks") {
    Scene scene = test::glass_ball_scene();
    scene.materials[0].name = "tinted  glass of 2";
    State state;
    state.show(test::opened(scene));
    test::run_and_wait(state, "change.set", "/materials/tinted  glass of 2/ior  1.75");
    CHECK(scene_of(state).materials[0].ior == 1.75);
    CHECK_THROWS_AS(run_command(state, "change.set", "/materials/none such/ior 1.75"), InputError);
}

TEST_CASE("app: branches that a change cuts off stay as ghosts until they are let go of") {
    State state = glass_ball_state();
    state.pick({40, 30});
    const auto before = state.tree()->tree.rays.size();
    test::run_and_wait(state, "change.set", "/settings/max_depth 2");
    const PixelTree& tree = *state.tree();
    CHECK(tree.grafted == before - tree.own());
    CHECK(tree.grafted > 0);
    for (std::size_t ray = 0; ray < tree.tree.rays.size(); ++ray) {
        CHECK((tree.mark(ray) == RayMark::cut) == (ray >= tree.own()));
        CHECK((tree.tree.rays[ray].level > 2) == (ray >= tree.own()));
    }
    state.select(tree.tree.rays.size() - 1);  // a ghost can be looked at
    CHECK(state.selected()->level > 2);
    test::run_and_wait(state, "change.dismiss");
    CHECK(state.tree()->grafted == 0);
    CHECK_FALSE(find_command("change.dismiss")->possible(state));
}

TEST_CASE("app: the next change lets go of the ghosts of the last") {
    State state = glass_ball_state();
    state.pick({40, 30});
    test::run_and_wait(state, "change.set", "/settings/max_depth 2");
    test::run_and_wait(state, "change.set", "/materials/glass/kd 0.2");
    CHECK(state.tree()->grafted == 0);
}

TEST_CASE("app: the selected ray stays selected when a value is changed") {
    State state = glass_ball_state();
    state.pick({40, 30});
    const auto& rays = state.tree()->tree.rays;
    std::size_t refracted = 0;
    while (rays[refracted].kind != RayKind::refracted) {
        ++refracted;
    }
    state.select(refracted);
    test::run_and_wait(state, "change.set", "/materials/glass/ior 1.6");
    CHECK(state.selected()->kind == RayKind::refracted);
    CHECK(state.selected()->level == 2);
}

TEST_CASE("app: undo, redo and reset give the values back") {
    State state = glass_ball_state();
    const double before = scene_of(state).materials[0].ior;
    CHECK_FALSE(find_command("change.undo")->possible(state));
    test::run_and_wait(state, "change.set", "/materials/glass/ior 1.6");
    test::run_and_wait(state, "change.set", "/materials/glass/kt 0.5, 0.4, 0.3");
    CHECK(scene_of(state).materials[0].kt == Colour{0.5, 0.4, 0.3});
    test::run_and_wait(state, "change.undo");
    CHECK(scene_of(state).materials[0].kt == Colour(0.8));
    CHECK(scene_of(state).materials[0].ior == 1.6);
    test::run_and_wait(state, "change.undo");
    CHECK(scene_of(state).materials[0].ior == before);
    CHECK_FALSE(state.edits().unsaved());
    test::run_and_wait(state, "change.redo");
    CHECK(scene_of(state).materials[0].ior == 1.6);
    CHECK(state.edits().unsaved());
    test::run_and_wait(state, "change.redo");
    test::run_and_wait(state, "change.reset");
    CHECK(scene_of(state).materials[0].ior == before);
    CHECK(scene_of(state).materials[0].kt == Colour(0.8));
    test::run_and_wait(state, "change.undo");  // reset is a change like others
    CHECK(scene_of(state).materials[0].kt == Colour{0.5, 0.4, 0.3});
}

TEST_CASE("app: a drag is one change, and its ghosts are those of all of it") {
    State state = glass_ball_state();
    state.pick({40, 30});
    const std::size_t all = state.tree()->own();
    for (const char* depth : {"3", "2", "1"}) {
        test::run_and_wait(state, "change.drag", std::string("/settings/max_depth ") + depth);
    }
    CHECK(state.tree()->tree.rays.size() == all);
    test::run_and_wait(state, "change.let_go");
    test::run_and_wait(state, "change.drag", "/settings/max_depth 3");
    test::run_and_wait(state, "change.undo");
    CHECK(scene_of(state).settings.max_depth == 1);
    test::run_and_wait(state, "change.undo");
    CHECK(scene_of(state).settings.max_depth == 4);
}

TEST_CASE("app: bad values change nothing and get the message that a file gets") {
    State state = glass_ball_state();
    const auto before = state.document();
    for (const auto& [value, json] :
         {std::pair("/settings/max_depth 65", R"({"max_depth": 65})"),
          std::pair("/settings/max_depth 2.5", R"({"max_depth": 2.5})"),
          std::pair("/settings/max_depth deep", R"({"max_depth": "deep"})"),
          std::pair("/settings/min_weight -1", R"({"min_weight": -1})"),
          std::pair("/settings/shadows soft", R"({"shadows": "soft"})"),
          std::pair("/settings/max_distance 0", R"({"max_distance": 0})")}) {
        const std::string message = refused(state, value);
        CAPTURE(message);
        CHECK(message.find(file_message(json)) != std::string::npos);
    }
    CHECK(refused(state, "/settings/attenuation/1 -2").find("/settings/attenuation") !=
          std::string::npos);
    CHECK(refused(state, "/materials/glass/ior 0").find("/materials/glass/ior") !=
          std::string::npos);
    CHECK(refused(state, "/materials/glass/kr 1, 2").find("3 numbers") != std::string::npos);
    CHECK(refused(state, "/lights/1/direction/1 0").find("/lights/1/direction") !=
          std::string::npos);
    for (const char* nowhere : {"/settings/depth 1", "/lights/7/intensity 1", "/objects/0/radius 1",
                                "/camera/width 5", "/materials/wood/kd 1", "max_depth 3"}) {
        CHECK(refused(state, nowhere).find("no such value") != std::string::npos);
    }
    CHECK_FALSE(refused(state, "/settings/max_depth").empty());
    CHECK(state.document() == before);
    CHECK_FALSE(state.edits().can_undo());
}

TEST_CASE("app: every knob can be set to what it is and to what its slider says") {
    State state = glass_ball_state();
    for (const KnobOwner owner : owners_of(scene_of(state))) {
        for (const Knob& knob : knobs_of(scene_of(state), owner)) {
            CAPTURE(knob.place);
            const std::string text = text_of(scene_of(state), knob.place);
            state.change(knob.place, text);
            CHECK(text_of(scene_of(state), knob.place) == text);
            for (const double value : {knob.least, (knob.least + knob.most) / 2, knob.most}) {
                const bool whole =
                    knob.kind == Knob::Kind::whole || knob.kind == Knob::Kind::choice;
                const double due = whole ? std::floor(value) : value;
                const std::string turned = slider_text(scene_of(state), knob, due);
                const bool vanishes = knob.place.starts_with("/lights/1/direction") ||
                                      knob.place.ends_with("/max_distance") ||
                                      knob.place.ends_with("/attenuation/0");
                if (!vanishes || due > 0) {
                    state.change(knob.place, turned);
                    CHECK(number_of(scene_of(state), knob) == doctest::Approx(due).epsilon(0.01));
                }
            }
            state.change(knob.place, text);
        }
    }
}

TEST_CASE("app: a colour's slider keeps the proportions of its channels") {
    State state = glass_ball_state();
    state.change("/materials/glass/kt", "0.8, 0.4, 0.2");
    const auto knobs = knobs_of(scene_of(state), {KnobOwner::Kind::material, 0});
    const auto kt = std::ranges::find(knobs, "/materials/glass/kt", &Knob::place);
    CHECK(slider_text(scene_of(state), *kt, 0.4) == "0.4, 0.2, 0.1");
}

TEST_CASE("app: a material inside of an object is changed there, and its messages say so") {
    Scene scene = test::glass_ball_scene();
    scene.materials[1].in_place = true;
    scene.materials[1].name = "floor";
    State state;
    state.show(test::opened(scene));
    state.change("/objects/1/material/kd", "0.25");
    CHECK(scene_of(state).materials[1].kd == Colour(0.25));
    CHECK(scene_of(state).materials[1].in_place);
    CHECK(scene_of(state).materials[0].kd == Colour(0.1));
    const std::string message = refused(state, "/objects/1/material/kd -1");
    CHECK(message.find("/objects/1/material/kd: ") != std::string::npos);
}

TEST_CASE("app: a limit that may be missing takes none") {
    State state = glass_ball_state();
    CHECK(text_of(scene_of(state), "/settings/max_distance") == "none");
    state.change("/settings/max_distance", "7");
    CHECK(scene_of(state).settings.max_distance == 7.0);
    state.change("/settings/max_distance", "none");
    CHECK_FALSE(scene_of(state).settings.max_distance);
}

TEST_CASE("app: a saved scene is read back with its changes, and is saved from then on") {
    const fs::path file = test::own_path("raytree-save-test.json");
    State state = glass_ball_state();
    state.change("/materials/glass/ior", "1.7");
    CHECK(state.edits().unsaved());
    test::run_and_wait(state, "file.save_as", file.string());
    CHECK_FALSE(state.edits().unsaved());
    CHECK(load_scene(file).scene.materials[0].ior == 1.7);
    state.change("/materials/glass/ior", "1.8");
    test::run_and_wait(state, "file.save");
    CHECK(load_scene(file).scene.materials[0].ior == 1.8);
    CHECK_FALSE(find_command("file.save")->possible(state));
    fs::remove(file);
}

TEST_CASE("app: what a format cannot say is said when the scene is saved in it") {
    const fs::path file = test::own_path("raytree-save-test.nff");
    State state = glass_ball_state();
    state.change("/settings/max_depth", "3");
    test::run_and_wait(state, "file.save_as", file.string());
    CHECK(state.message().find("Not said in it") != std::string::npos);
    CHECK(state.edits().unsaved());
    fs::remove(file);
}

TEST_CASE("app: a scene that is read again keeps pixel and look, and shows what it has cut") {
    State state = glass_ball_state();
    state.pick({40, 30});
    Scene scene = test::glass_ball_scene();
    scene.settings.max_depth = 1;
    state.change("/materials/glass/ior", "1.7");
    std::vector<Changes> told;
    state.observe([&](const Changes& changes) { told.push_back(changes); });
    state.renew(test::opened(scene));
    CHECK(state.pixel() == Pixel{40, 30});
    CHECK(state.tree()->grafted > 0);
    CHECK_FALSE(state.edits().can_undo());
    for (const Changes& changes : told) {
        CHECK_FALSE(changes.document);
    }
}

TEST_CASE("app: what a format cannot say is told once, and of much the first few") {
    Scene scene = test::glass_ball_scene();
    for (int k = 0; k < 9; ++k) {  // lights that weaken with the distance: NFF has none
        Light light;
        light.name = "lamp" + std::to_string(k);
        light.kind = PointLight{{1.0 * k, 5, 0}, Attenuation{1, 0, 0.1}};
        scene.lights.push_back(light);
    }
    State state;
    state.show(test::opened(std::move(scene)));
    const auto file = test::own_path("left-out.nff");
    run_command(state, "file.save_as", file.string());
    std::filesystem::remove(file);
    const std::string& message = state.message();
    CHECK(message.find("Not said in it") == message.rfind("Not said in it"));
    CHECK(std::ranges::count(message, '\n') == 1);
    CHECK(message.size() < 700);
}

}  // namespace
}  // namespace raytree::inspector
