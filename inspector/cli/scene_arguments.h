#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "formats/scene_file.h"
#include "math/real.h"

/// The arguments that all subcommands which read a scene have in common.
namespace raytree::cli {

struct SceneArguments {
    std::string file;
    SceneOptions options;
    int threads = 0;  ///< 0: all cores

    /// Loads the scene; what its reader warns of goes to standard error.
    LoadedScene load() const;
};

void add_scene_arguments(CLI::App& app, SceneArguments& arguments);
/// The same without the scene's name, for commands that are about something else.
void add_scene_options(CLI::App& app, SceneArguments& arguments);

enum class Precision { single, twice, reference };

void add_precision(CLI::App& app, Precision& precision);

/// Calls `function.operator()<T>()` with the arithmetic T that was chosen.
template <class Function> decltype(auto) with_arithmetic(Precision precision, Function&& function) {
    switch (precision) {
        case Precision::single:
            return function.template operator()<float>();
        case Precision::reference:
            return function.template operator()<Quad>();
        default:
            return function.template operator()<double>();
    }
}

/// A line on standard error that begins with the program's name.
void say(const std::string& text);

}  // namespace raytree::cli
