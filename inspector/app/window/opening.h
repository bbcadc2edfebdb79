#pragma once

#include <filesystem>
#include <optional>

#include "state/document.h"

namespace raytree::inspector {

/// Reads a file as `open_file` does, for a window: the pixel to begin with and all that its views
/// look for in the scene are found here, in whatever thread it is read. A hierarchy grows where
/// rays are sent, and the window's own first rays then find it grown.
Opened open_for_window(const std::filesystem::path& file,
                       const std::optional<std::filesystem::path>& scene_of_tree = {});

}  // namespace raytree::inspector
