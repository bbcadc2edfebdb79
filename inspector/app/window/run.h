#pragma once

#include <filesystem>
#include <optional>

#include "state/state.h"

namespace raytree::inspector {

struct WindowOptions {
    std::optional<std::filesystem::path> screenshot;  ///< drawn once, written, and ended
    int width = 1280;
    int height = 800;
};

/// Shows the state in a window until it is closed. There must be a display. Returns the exit code;
/// throws InputError where the screenshot cannot be written.
int run_window(int& argc, char** argv, State& state, const WindowOptions& options);

}  // namespace raytree::inspector
