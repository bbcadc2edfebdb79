#include <filesystem>
#include <memory>

#include "command.h"
#include "formats/scene_file.h"
#include "scene_arguments.h"

namespace raytree::cli {
namespace {

constexpr const char* examples =
    "Examples:\n"
    "  raytree convert balls.nff balls.json                  into the project's own format\n"
    "  raytree convert balls.nff small.json --size 64x64     changed on the way";

struct Arguments {
    SceneArguments scene;
    std::string output;
};

int convert(const Arguments& arguments) {
    Scene scene = arguments.scene.load().scene;
    relocate_meshes(scene, std::filesystem::path(arguments.scene.file).parent_path(),
                    std::filesystem::path(arguments.output).parent_path());
    for (const std::string& lost : save_scene(scene, arguments.output)) {
        say("not said in " + arguments.output + ": " + lost);
    }
    return done;
}

}  // namespace

Command convert_command(CLI::App& program) {
    const auto arguments = std::make_shared<Arguments>();
    CLI::App* const app =
        program.add_subcommand("convert", "A scene in another format, as far as that can say it.");
    app->footer(examples);
    add_scene_arguments(*app, arguments->scene);
    app->add_option("OUT", arguments->output, "the scene to write: .json, .nff or .txt")
        ->option_text(" ")
        ->required();
    return {app, [arguments] { return convert(*arguments); }};
}

}  // namespace raytree::cli
