#pragma once

#include <filesystem>
#include <functional>
#include <future>
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

/// Shows in a state what has been read.
using FirstView = std::function<void(State&)>;

/// Shows the state in a window until it is closed, what is shown first as soon as it has been read.
/// There must be a display. Returns the exit code; throws InputError where reading, a line of the
/// script or the screenshot fails.
int run_window(int& argc, char** argv, State& state, std::future<FirstView> reading,
               const WindowOptions& options);

}  // namespace raytree::inspector
