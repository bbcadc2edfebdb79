#include "state/state.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "app/scenes.h"
#include "folders.h"
#include "formats/tree_json.h"
#include "state/commands.h"
#include "state/start_pixel.h"
#include "tree/record.h"

namespace raytree::inspector {
namespace {

namespace fs = std::filesystem;

const fs::path data = RAYTREE_DATA_DIR;

/// A file that is gone when the test is over.
struct File {
    fs::path path;
    File(const std::string& name, const std::string& text)
        : path(test::own_path("raytree-app-test-" + name)) {
        std::ofstream(path, std::ios::binary) << text;
    }
    ~File() { fs::remove(path); }
};

State glass_ball_state() {
    State state;
    state.show(test::opened(test::glass_ball_scene()));
    return state;
}

TEST_CASE(
    "app: a scene that is shown has a pixel with many kinds of rays, its tree, and the "
    "primary ray selected") {
    State state = glass_ball_state();
    REQUIRE(state.tree());
    CHECK(state.document()->contains(state.pixel()));
    CHECK(state.tree()->tree.counts.reflected > 0);
    CHECK(state.tree()->tree.counts.refracted > 0);
    CHECK(state.selected()->id == 0);
}

TEST_CASE("app: a picture of one pixel has that pixel chosen") {
    Scene scene = test::glass_ball_scene();
    scene.camera.width = scene.camera.height = 1;
    CHECK(start_pixel(*test::document_of(scene)) == Pixel{0, 0});
}

TEST_CASE("app: views are told what has changed, once for each change") {
    State state = glass_ball_state();
    state.pick({0, 0});
    std::vector<Changes> told;
    state.observe([&](const Changes& changes) { told.push_back(changes); });
    state.pick({40, 30});
    state.select(1);
    state.select(1);  // already is
    state.pick({40, 30});
    state.change_look([](Look& look) { look.theme = Theme::dark; });
    state.request(Request::from_side);
    REQUIRE(told.size() == 4);
    CHECK((told[0].tree && told[0].selection && !told[0].document));
    CHECK((told[1].selection && !told[1].tree));
    CHECK((told[2].look && !told[2].selection));
    CHECK(told[3].request == Request::from_side);
}

TEST_CASE("app: a pixel outside the picture is the nearest in it") {
    State state = glass_ball_state();
    state.pick({-5, 1000});
    CHECK(state.pixel() == Pixel{0, 59});
    CHECK(state.tree()->tree.pixel_j == 59);
}

TEST_CASE("app: the tree is the one that the library records") {
    State state = glass_ball_state();
    state.pick({40, 30});
    const auto truth = record_tree(state.document()->world(), 40, 30);
    REQUIRE(state.tree()->tree.rays.size() == truth.rays.size());
    CHECK(state.tree()->tree.intensity == truth.intensity);
}

TEST_CASE("app: stepping goes through all rays in order and back") {
    State state = glass_ball_state();
    const std::size_t count = state.tree()->tree.rays.size();
    REQUIRE(count > 5);
    for (std::size_t k = 1; k < count; ++k) {
        run_command(state, "ray.next");
        CHECK(state.selected()->id == k);
    }
    CHECK_FALSE(find_command("ray.next")->possible(state));
    run_command(state, "ray.next");  // stays
    CHECK(state.selected()->id == count - 1);
    for (std::size_t k = 1; k < count; ++k) {
        run_command(state, "ray.previous");
    }
    CHECK(state.selected()->id == 0);
}

TEST_CASE("app: stepping leaves out hidden kinds") {
    State state = glass_ball_state();
    run_command(state, "show.shadow");
    while (find_command("ray.next")->possible(state)) {
        run_command(state, "ray.next");
        CHECK(state.selected()->kind != RayKind::shadow);
    }
}

TEST_CASE("app: parent, child and sibling walk the tree") {
    State state = glass_ball_state();
    run_command(state, "ray.child");
    CHECK(state.selected()->parent == 0);
    const std::size_t first = state.selected()->id;
    run_command(state, "ray.sibling");
    CHECK(state.selected()->parent == 0);
    CHECK(state.selected()->id > first);
    run_command(state, "ray.parent");
    CHECK(state.selected()->id == 0);
    CHECK_FALSE(find_command("ray.parent")->possible(state));
}

TEST_CASE("app: what belongs to a ray is the way to it and its children") {
    State state = glass_ball_state();
    const PixelTree& tree = *state.tree();
    for (const auto& ray : tree.tree.rays) {
        if (ray.id == 0) {
            continue;
        }
        CHECK(belongs_to(tree, ray.id, ray.id));
        CHECK(belongs_to(tree, ray.id, 0));
        CHECK(belongs_to(tree, ray.id, *ray.parent));
        for (const std::size_t child : tree.children[ray.id]) {
            CHECK(belongs_to(tree, ray.id, child));
        }
    }
    // Of two siblings, neither belongs to the other.
    const auto& children = tree.children[0];
    REQUIRE(children.size() >= 2);
    CHECK_FALSE(belongs_to(tree, children[0], children[1]));
}

TEST_CASE("app: arrow commands move the pixel by one and by ten") {
    State state = glass_ball_state();
    state.pick({40, 30});
    run_command(state, "pixel.left");
    run_command(state, "pixel.up");
    CHECK(state.pixel() == Pixel{39, 29});
    run_command(state, "pixel.far_right");
    run_command(state, "pixel.far_down");
    CHECK(state.pixel() == Pixel{49, 39});
}

TEST_CASE("app: commands have ids, titles and help, and no key means two things") {
    std::set<std::string> ids, keys;
    for (const Command& command : commands()) {
        CHECK(ids.insert(std::string(command.id)).second);
        CHECK_FALSE(command.title.empty());
        CHECK(command.help.ends_with('.'));
        CHECK(static_cast<bool>(command.run));
        std::istringstream list{std::string(command.keys)};
        for (std::string key; list >> key;) {
            CHECK_MESSAGE(keys.insert(key).second, key);
        }
    }
}

TEST_CASE("app: commands that need a scene do nothing without one") {
    State state;
    for (const Command& command : commands()) {
        if (command.argument == Argument::none) {
            CHECK_NOTHROW(run_command(state, command.id));
        }
    }
    CHECK(state.tree() == nullptr);
}

TEST_CASE("app: lines of a script are commands with arguments") {
    State state = glass_ball_state();
    run_line(state, "");
    run_line(state, "  # a remark");
    run_line(state, "  pixel.pick   12,34  ");
    CHECK(state.pixel() == Pixel{12, 34});
    run_line(state, "ray.select 1");
    CHECK(state.selected()->id == 1);
    CHECK_THROWS_AS(run_line(state, "ray.select 100000"), InputError);
    CHECK_THROWS_AS(run_line(state, "ray.select one"), InputError);
    CHECK_THROWS_AS(run_line(state, "no.such"), InputError);
    // What may be said besides is taken.
    run_line(state, "explain.shower sun");
    CHECK(state.explained().shower);
    run_line(state, "explain.nothing");
    CHECK_THROWS_WITH_AS(run_line(state, "lesson.open no such lesson"),
                         doctest::Contains("no such lesson"), InputError);
    // Nobody would see that these do nothing.
    CHECK_FALSE(run_line(state, "compare.next"));
    CHECK_FALSE(run_line(state, "change.undo"));
    CHECK(run_line(state, "ray.primary"));
    state.select(1);
    CHECK_THROWS_WITH_AS(run_line(state, "overlay.rays 3"), doctest::Contains("found '3'"),
                         InputError);
    CHECK_THROWS_AS(run_line(state, "step.to 99999"), InputError);
    CHECK_FALSE(state.playback());
    run_line(state, "step.to " + std::to_string(state.stops()));
    CHECK(state.playback()->at_end());
    CHECK_THROWS_AS(run_line(state, "step.to " + std::to_string(state.stops() + 1)), InputError);
    run_line(state, "step.mode");
    state.select(1);
    for (const char* const line : {"file.open", "export.tree_json", "compare.file"}) {
        CHECK_THROWS_WITH_AS(run_line(state, line), doctest::Contains("a file's name"), InputError);
    }
    std::optional<lesson::FreeView> from;
    state.observe(
        [&](const Changes& changes) { from = changes.view_from ? changes.view_from : from; });
    run_line(state, "view.from 1,2,3  0,-0.5,1e1");
    REQUIRE(from);
    CHECK(from->eye == Vec3<double>(1, 2, 3));
    CHECK(from->target == Vec3<double>(0, -0.5, 10));
    for (const char* bad :
         {"", "1,2,3", "1 2 3 4 5 6 7", "1,2,3,1,2,3", "1,2,x,4,5,6", "1,2,3,4,5,inf"}) {
        CHECK_THROWS_AS(run_line(state, std::string("view.from ") + bad), InputError);
    }
    CHECK(state.selected()->id == 1);
}

TEST_CASE("app: pixels are written I,J and nothing else") {
    CHECK(pixel_from("320,240") == Pixel{320, 240});
    for (const char* bad : {"", "320", "320,", ",240", "320;240", "320,240,1", "a,b", "1.5,2"}) {
        CHECK_THROWS_AS(pixel_from(bad), InputError);
    }
}

TEST_CASE("app: opening a broken file leaves the state as it was") {
    State state = glass_ball_state();
    const auto before = state.document();
    const File broken("broken.json", "{\"format\": \"raytree-scene/1.0\", ");
    CHECK_THROWS_AS(run_command(state, "file.open", broken.path.string()), InputError);
    CHECK_THROWS_AS(run_command(state, "file.open", "/no/such/file.json"), InputError);
    CHECK(state.document() == before);
}

TEST_CASE("app: reading a file again keeps the pixel") {
    State state;
    run_command(state, "file.open", (data / "scenes/glass-ball.json").string());
    state.pick({100, 200});
    run_command(state, "file.reload");
    CHECK(state.pixel() == Pixel{100, 200});
    CHECK_FALSE(state.message().empty());
}

TEST_CASE("app: a tree with its scene inside opens as that scene and pixel") {
    const Scene scene = test::glass_ball_scene();
    const auto tree = record_tree(test::document_of(scene)->world(), 41, 22);
    const File file("with-scene.json", write_tree_json(tree, &scene));
    State state;
    test::run_and_wait(state, "file.open", file.path.string());
    CHECK(state.pixel() == Pixel{41, 22});
    CHECK(state.tree()->tree.intensity == tree.intensity);
    CHECK(state.message().find("the same in both") != std::string::npos);
}

TEST_CASE("app: a tree without its scene wants it, and differences to it are told") {
    const Scene scene = test::glass_ball_scene();
    auto tree = record_tree(test::document_of(scene)->world(), 41, 22);
    tree.intensity.r += 0.1;
    const File alone("alone.json", write_tree_json(tree));
    CHECK_THROWS_AS(open_file(alone.path), SceneWanted);
    tree.pixel_i = 5;
    const File with("wrong.json", write_tree_json(tree, &scene));
    State state;
    test::run_and_wait(state, "file.open", with.path.string());
    CHECK(state.message().find("different") != std::string::npos);
}

const Scene& scene_of(const State& state) { return state.document()->scene(); }

/// Between mirrors, with a budget of so many rays.
Scene heavy_scene(std::size_t rays) {
    Scene scene = test::glass_ball_scene();
    scene.settings.max_depth = 64;
    scene.settings.min_weight = 0;
    scene.settings.ray_budget = rays;
    for (Material& material : scene.materials) {
        material.kr = material.kt = Colour(0.9);
    }
    std::get<Polygon>(scene.objects[1].shape) =
        Polygon{{{-90, -1, 90}, {90, -1, 90}, {90, -1, -90}, {-90, -1, -90}}, {}};
    scene.objects.push_back(scene.objects[1]);
    scene.objects.back().name = "ceiling";
    for (Point& vertex : std::get<Polygon>(scene.objects.back().shape).vertices) {
        vertex.y = 5;
    }
    return scene;
}

TEST_CASE("app: a tree that takes long comes later, and of several pixels the last one's") {
    State state;
    state.show({test::document_of(heavy_scene(400'000)), Pixel{40, 30}, {}});
    state.pick({41, 30});
    state.pick({42, 30});
    int told = 0;
    state.observe([&](const Changes& changes) { told += changes.tree; });
    const bool late = state.working();
    for (int k = 0; k < 1000 && state.working(); ++k) {
        CHECK(state.selected() == nullptr);
        state.poll(std::chrono::milliseconds(20));
    }
    REQUIRE(state.tree());
    CHECK(told == (late ? 1 : 0));
    CHECK(state.tree()->tree.pixel_i == 42);
    CHECK(state.tree()->tree.rays.size() > 10'000);
    CHECK(state.message().empty());
}

TEST_CASE("app: what a change takes long over leaves what is shown; of several the last comes") {
    Scene scene = heavy_scene(1'000'000);
    scene.settings.max_depth = 3;
    State state;
    state.show({test::document_of(scene), Pixel{40, 30}, {}});
    state.poll(std::chrono::seconds(60));
    REQUIRE(state.tree());
    const auto document = state.document();
    const auto tree = state.tree();
    int values = 0;
    state.observe([&](const Changes& changes) { values += changes.values; });
    state.change("/settings/max_depth", "40", Pick::on_the_way);
    state.change("/settings/max_depth", "41", Pick::on_the_way);
    const bool late = state.working();
    if (late) {
        CHECK(state.document() == document);
        CHECK(state.tree() == tree);
        CHECK(!state.message().empty());
    }
    state.change("/settings/max_depth", "2", Pick::on_the_way);
    state.poll(std::chrono::seconds(60));
    CHECK(scene_of(state).settings.max_depth == 2);
    CHECK(state.tree()->tree.settings.max_depth == 2);
    CHECK(state.message().empty());
    CHECK(values == (late ? 1 : 3));
    state.undo();  // all of them are one change
    state.poll(std::chrono::seconds(60));
    CHECK(scene_of(state).settings.max_depth == 3);
}

TEST_CASE("app: a change goes on from those before it, shown or not") {
    State state;
    state.show({test::document_of(heavy_scene(1'000'000)), Pixel{40, 30}, {}});
    state.change("/settings/max_depth", "5");
    state.change("/settings/min_weight", "0.25");
    state.poll(std::chrono::seconds(60));
    CHECK(scene_of(state).settings.max_depth == 5);
    CHECK(scene_of(state).settings.min_weight == 0.25);
    CHECK(state.tree()->tree.settings.max_depth == 5);
}

TEST_CASE("app: where intensities are not finite the pixel has no tree, and it is said") {
    Scene scene = test::glass_ball_scene();
    scene.lights[0].intensity = Colour(1e308);
    scene.materials[1].kd = Colour(1e10);
    State state;
    state.show(test::opened(scene));
    for (int i = 0; i < 80 && state.tree(); ++i) {
        state.pick({i, 55});
    }
    REQUIRE_FALSE(state.tree());
    CHECK(state.selected() == nullptr);
    CHECK(state.message().find("largest number") != std::string::npos);
    CHECK_NOTHROW(run_command(state, "ray.next"));
}

}  // namespace
}  // namespace raytree::inspector
