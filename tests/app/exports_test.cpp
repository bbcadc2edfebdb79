#include "state/exports.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "app/scenes.h"
#include "folders.h"
#include "formats/image.h"
#include "formats/output_file.h"
#include "formats/tree_json.h"
#include "formats/tree_text.h"
#include "state/commands.h"

namespace raytree::inspector {
namespace {

namespace fs = std::filesystem;

const fs::path glass_ball = fs::path(RAYTREE_DATA_DIR) / "scenes/glass-ball.json";

/// A folder that is gone when the test is over.
struct Folder {
    fs::path path = test::own_path("raytree-export-test");
    Folder() {
        fs::remove_all(path);
        fs::create_directory(path);
    }
    ~Folder() { fs::remove_all(path); }
    std::string file(const char* name) const { return (path / name).string(); }
};

State opened_state() {
    State state;
    run_command(state, "file.open", glass_ball.string());
    state.pick({210, 286});
    return state;
}

TEST_CASE("app: trees are exported as the library writes them") {
    State state = opened_state();
    const Folder folder;
    for (const Command& command : commands()) {
        if (command.id.starts_with("export.tree")) {
            const std::string file = folder.file("tree.out");
            run_command(state, command.id, file);
            CHECK_MESSAGE(fs::file_size(file) > 1000, command.id);
            CHECK(state.message() == "Written: " + file);
            fs::remove(file);
        }
    }
    run_command(state, "export.tree_json", folder.file("tree.json"));
    CHECK(read_input(folder.file("tree.json")) == write_tree_json(state.tree()->tree));
    run_command(state, "export.tree_text", folder.file("tree.txt"));
    CHECK(read_input(folder.file("tree.txt")) == write_tree_text(state.tree()->tree));
}

TEST_CASE("app: a tree exported with its scene opens by itself") {
    State state = opened_state();
    const Folder folder;
    run_command(state, "export.tree_with_scene", folder.file("tree.json"));
    test::run_and_wait(state, "file.open", folder.file("tree.json"));
    CHECK(state.pixel() == Pixel{210, 286});
    CHECK(state.message().find("the same in both") != std::string::npos);
}

TEST_CASE("app: a scene that is exported is the same when it is opened") {
    State state = opened_state();
    const auto before = state.tree()->tree.intensity;
    const Folder folder;
    run_command(state, "export.scene", folder.file("scene.json"));
    run_command(state, "file.open", folder.file("scene.json"));
    state.pick({210, 286});
    CHECK(state.tree()->tree.intensity == before);
}

TEST_CASE("app: pictures are exported in the format that the name says") {
    State state;
    state.show(test::opened(test::glass_ball_scene()));
    const Picture picture = render(state.document()->world());
    const Folder folder;
    export_picture(state, picture, folder.file("p.png"));
    CHECK(read_png(read_input(folder.file("p.png")), "") ==
          quantized(picture, state.document()->scene().settings.quantize).image);
    export_picture(state, picture, folder.file("p.pfm"));
    CHECK(read_input(folder.file("p.pfm")) == encode_pfm(picture));
    export_picture(state, picture, folder.file("p.PPM"));
    CHECK(read_input(folder.file("p.PPM")).starts_with("P6"));
    CHECK_THROWS_AS(expect_picture(state, folder.file("p.gif")), InputError);
}

TEST_CASE("app: nothing is written over the open scene, a folder, or where there is no folder") {
    State state = opened_state();
    const Folder folder;
    const std::string scene = read_input(glass_ball);
    for (const Command& command : commands()) {
        // A scene may be saved into its own file, and is not here.
        if (command.argument == Argument::new_file && command.id != "file.save_as") {
            for (const std::string& file :
                 {glass_ball.string(), folder.path.string(), folder.file("none/tree.json")}) {
                CHECK_THROWS_AS(run_command(state, command.id, file), InputError);
            }
        }
    }
    for (const std::string& file : {folder.path.string(), folder.file("none/scene.json")}) {
        CHECK_THROWS_AS(run_command(state, "file.save_as", file), InputError);
    }
    CHECK(read_input(glass_ball) == scene);
    CHECK(fs::is_empty(folder.path));
}

TEST_CASE("app: a new file's name tells the scene, the pixel and the kind") {
    State state = opened_state();
    const auto name = [&](const char* id) { return suggested_name(state, *find_command(id)); };
    CHECK(name("export.tree_svg") == "glass-ball-210-286.svg");
    CHECK(name("export.picture") == "glass-ball.png");
    CHECK(name("export.scene") == "glass-ball-copy.json");
}

}  // namespace
}  // namespace raytree::inspector
