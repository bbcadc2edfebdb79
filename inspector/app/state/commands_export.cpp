#include "state/command_groups.h"
#include "state/exports.h"

namespace raytree::inspector {
namespace {

template <TreeExport as> void write_tree(State& state, std::string_view file) {
    export_tree(state, as, std::string(file));
}
void write_scene(State& state, std::string_view file) { export_scene(state, std::string(file)); }
template <Request request> void write(State& state, std::string_view file) {
    expect_writable(state, std::string(file));
    state.request(request, std::string(file));
}

void write_view(State& state, std::string_view file_and_size) {
    expect_writable(state, view_export_from(std::string(file_and_size)).file);
    state.request(Request::export_view, std::string(file_and_size));
}

constexpr Command writes_file(std::string_view id, std::string_view title, std::string_view keys,
                              std::string_view help, void (*run)(State&, std::string_view),
                              bool (*possible)(const State&), std::string_view suffixes,
                              bool rule_before = false) {
    return {id,  "Export", title,   keys, help,        Argument::new_file,
            run, possible, nullptr, {},   rule_before, suffixes};
}

constexpr Command table[] = {
    writes_file("export.tree_json", "Tree as JSON…", "Ctrl+E", "Writes the ray tree (raytree/1.0).",
                write_tree<TreeExport::json>, has_tree, "json"),
    writes_file("export.tree_with_scene", "Tree with its scene…", "",
                "Writes the ray tree (raytree/1.0) and the whole scene in one file.",
                write_tree<TreeExport::json_with_scene>, has_tree, "json"),
    writes_file("export.tree_text", "Tree as text…", "",
                "Writes the ray tree as an outline to read.", write_tree<TreeExport::text>,
                has_tree, "txt"),
    writes_file("export.tree_dot", "Tree as DOT…", "",
                "Writes the ray tree as a graph for Graphviz.", write_tree<TreeExport::dot>,
                has_tree, "dot"),
    writes_file("export.tree_svg", "Tree as SVG…", "", "Writes the ray tree as a drawing.",
                write_tree<TreeExport::svg>, has_tree, "svg"),
    writes_file("export.tree_vtp", "Tree as VTP…", "",
                "Writes the ray tree as lines in space, for ParaView.", write_tree<TreeExport::vtp>,
                has_tree, "vtp"),
    writes_file("export.picture", "Picture…", "",
                "Renders the picture and writes it: .png or .ppm, or .pfm with unclamped numbers.",
                write<Request::export_picture>, has_scene, "png ppm pfm", true),
    writes_file("export.view", "3D view as an image…", "",
                "Writes the 3D view as an image (.png) of any size, such as: view.png 3840x2160.",
                write_view, has_scene, "png"),
    writes_file("export.window", "Window as an image…", "", "Writes the window as it is (.png).",
                write<Request::export_window>, has_scene, "png"),
    writes_file("export.scene", "Scene…", "Ctrl+S",
                "Writes the scene: .json, or .nff or .txt as far as they can say it.", write_scene,
                has_scene, "json nff txt", true),
    {"copy.view",
     "Export",
     "Copy the 3D view",
     "Ctrl+Shift+C",
     "Copies the 3D view as an image.",
     none,
     ask<Request::copy_view>,
     has_scene,
     nullptr,
     {},
     true},
    {"copy.window", "Export", "Copy the window", "Ctrl+Alt+C", "Copies the window as an image.",
     none, ask<Request::copy_window>, has_scene},
};

}  // namespace

std::span<const Command> export_commands() { return table; }

}  // namespace raytree::inspector
