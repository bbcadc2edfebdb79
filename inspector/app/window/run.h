#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "state/state.h"

namespace raytree::inspector {

struct WindowOptions {
    std::optional<std::filesystem::path> screenshot;     ///< drawn once, written, and ended
    std::optional<std::filesystem::path> contact_sheet;  ///< folder for all steps of all lessons
    std::vector<std::string> script;  ///< commands that are run once the window is there
    int width = 1280;
    int height = 800;
};

/// To be called before there is a QApplication: VTK draws through X11 alone, with OpenGL of a
/// version of its own.
void prepare_qt();

/// Shows the state in a window until it is closed. There must be a display. Returns the exit code;
/// throws InputError where a line of the script or the
/// screenshot fails.
int run_window(int& argc, char** argv, State& state, const WindowOptions& options);

}  // namespace raytree::inspector
