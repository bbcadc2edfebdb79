#pragma once

#include <optional>
#include <string>
#include <utility>

#include "trace/render.h"

/// What the inspector writes into files: whole or not at all, as the command line does.
namespace raytree::inspector {

class State;
struct Command;

enum class TreeExport { json, json_with_scene, text, dot, svg, vtp };

/// Writes what is shown and says so. Throws InputError where the file cannot be written.
void export_tree(State& state, TreeExport as, const std::string& file);
/// Says as well what the file's format cannot say.
void export_scene(State& state, const std::string& file);
/// In the format that the file's extension says. Says as well how many pixels were clamped.
void export_picture(State& state, const Picture& picture, const std::string& file);

/// Throws InputError where nothing can be written to the file, or where it is the open scene's.
void expect_writable(const State& state, const std::string& file);
/// The same, and where its extension is not a picture's.
void expect_picture(const State& state, const std::string& file);

/// The 3D view as an image: "view.png 3840x2160"; without a size that of the pane.
struct ViewExport {
    std::string file;
    std::optional<std::pair<int, int>> size;  ///< width and height, pixels
};
/// Throws InputError for a size outside 64 to 8192, and for a name that does not end in .png.
ViewExport view_export_from(const std::string& text);

/// "glass-ball-210-286.json": what a new file is called unless its name is changed.
std::string suggested_name(const State& state, const Command& command);

}  // namespace raytree::inspector
