#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "state/document.h"
#include "window/run.h"

namespace raytree::inspector {

/// What the command line says.
struct Arguments {
    bool help = false;
    bool version = false;
    std::optional<std::filesystem::path> file;     ///< a scene or a tree
    std::optional<std::filesystem::path> scene;    ///< of a tree that does not hold it
    std::optional<std::filesystem::path> compare;  ///< a recorded tree
    std::optional<Pixel> pixel;
    Theme theme = Theme::light;
    WindowOptions window;
};

/// Throws InputError for what it does not understand.
Arguments parse_arguments(std::span<char* const> words);

std::string help_text();

}  // namespace raytree::inspector
