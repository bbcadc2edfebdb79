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
    std::optional<std::filesystem::path> file;   ///< a scene or a tree
    std::optional<std::filesystem::path> scene;  ///< of a tree that does not hold it
    std::optional<Pixel> pixel;
    std::optional<std::string> lesson;             ///< its name or number
    std::optional<std::filesystem::path> lessons;  ///< the folder that they are in
    int step = 1;                                  ///< of the lesson, from 1
    Theme theme = Theme::light;
    WindowOptions window;
};

/// Throws InputError for what it does not understand.
Arguments parse_arguments(std::span<char* const> words);

std::string help_text();

}  // namespace raytree::inspector
