#include <filesystem>
#include <memory>

#include "command.h"
#include "formats/scene_file.h"
#include "scene_arguments.h"
#include "values.h"

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

/// A scene names its meshes' files relative to itself, and those do not move with it.
void miss_meshes(const Scene& scene, const std::filesystem::path& output) {
    for (const Object& object : scene.objects) {
        const auto* mesh = std::get_if<Mesh>(&object.shape);
        if (mesh && extension_of(output) == "json" &&
            !std::filesystem::exists(output.parent_path() / mesh->file)) {
            say("warning: " + output.string() + " needs the mesh " + mesh->file +
                ", which is not beside it; copy it there");
        }
    }
}

int convert(const Arguments& arguments) {
    const LoadedScene loaded = arguments.scene.load();
    for (const std::string& lost : save_scene(loaded.scene, arguments.output)) {
        say("not said in " + arguments.output + ": " + lost);
    }
    miss_meshes(loaded.scene, arguments.output);
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
