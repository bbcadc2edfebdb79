#include <memory>

#include "command.h"
#include "formats/output_file.h"
#include "scene_arguments.h"
#include "scene_report.h"
#include "trace/world.h"

namespace raytree::cli {
namespace {

constexpr const char* examples =
    "Examples:\n"
    "  raytree info scene.json           to read\n"
    "  raytree info scene.json --json    as data";

struct Arguments {
    SceneArguments scene;
    bool json = false;
};

int info(const Arguments& arguments) {
    const LoadedScene loaded = arguments.scene.load();
    const World<double> world(loaded.scene);
    const WideBvh& hierarchy = world.shapes.hierarchy();
    const SceneReport report{arguments.scene.file, loaded, plan_of(loaded.scene),
                             hierarchy.node_count(), hierarchy.bytes()};
    write_output("-", arguments.json ? report_json(report) : report_text(report));
    return done;
}

}  // namespace

Command info_command(CLI::App& program) {
    const auto arguments = std::make_shared<Arguments>();
    CLI::App* const app = program.add_subcommand(
        "info", "What a scene holds, what tracing it takes, and what is skipped.");
    app->footer(examples);
    app->add_flag("--json", arguments->json, "write JSON");
    add_scene_arguments(*app, arguments->scene);
    return {app, [arguments] { return info(*arguments); }};
}

}  // namespace raytree::cli
