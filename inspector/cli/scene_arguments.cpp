#include "scene_arguments.h"

#include <array>
#include <iostream>

#include "scene/utf8.h"
#include "values.h"

namespace raytree::cli {
namespace {

constexpr int most_threads = 1024;
constexpr std::array<std::string_view, 4> format_words = {"json", "nff", "txt", "obj"};
constexpr std::array<std::string_view, 3> precision_words = {"float", "double", "reference"};

void add_overrides(CLI::App& app, SceneOptions& options) {
    const char* const group = "Instead of what the scene says";
    add_value(app, "--size", "WxH", "picture size in pixels", [&](const std::string& text) {
        options.size = pair_of_numbers(text, 'x');
        if (!options.size) {
            throw wrong_value("--size", text, "WIDTHxHEIGHT in pixels, such as 640x480");
        }
    })->group(group);
    add_value(app, "--max-depth", "N", "levels of the tree, 1 to 64", [&](const std::string& text) {
        options.max_depth = whole_number(text);
        if (!options.max_depth) {
            throw wrong_value("--max-depth", text, "a whole number from 1 to 64");
        }
    })->group(group);
    const auto add_real = [&](const char* name, const char* value, const char* help,
                              std::optional<double>& target, const char* allowed) {
        add_value(app, name, value, help, [name, allowed, &target](const std::string& text) {
            target = real_number(text);
            if (!target) {
                throw wrong_value(name, text, allowed);
            }
        })->group(group);
    };
    add_real("--min-weight", "W", "leave out branches that weigh less; 0: none", options.min_weight,
             "a number, 0 or more");
    add_real("--max-distance", "D", "end rays whose path from the eye is longer",
             options.max_distance, "a number over 0");
}

}  // namespace

LoadedScene SceneArguments::load() const {
    LoadedScene loaded = load_scene(file, options);
    for (const std::string& warning : loaded.warnings) {
        say("warning: " + warning);
    }
    return loaded;
}

void add_scene_arguments(CLI::App& app, SceneArguments& arguments) {
    app.add_option("SCENE", arguments.file, "a scene: .json, .nff, .txt (course text) or .obj")
        ->option_text(" ")
        ->required();
    add_scene_options(app, arguments);
}

void add_scene_options(CLI::App& app, SceneArguments& arguments) {
    add_overrides(app, arguments.options);
    add_value(app, "--scene-format", "json|nff|txt|obj",
              "the scene's format where its name does not say it", [&](const std::string& text) {
                  const std::size_t k = one_of("--scene-format", text, format_words);
                  arguments.options.format = static_cast<SceneFormat>(k);
              });
    add_value(app, "--threads", "N", "work on N threads; all cores otherwise",
              [&](const std::string& text) {
                  const int threads = whole_number(text).value_or(0);
                  if (threads < 1 || threads > most_threads) {
                      throw wrong_value("--threads", text, "a whole number from 1 to 1024");
                  }
                  arguments.threads = threads;
              });
}

void add_precision(CLI::App& app, Precision& precision) {
    add_value(app, "--precision", "float|double|reference",
              "arithmetic to trace in (default: double); reference\nhas 113 significand bits",
              [&](const std::string& text) {
                  precision = static_cast<Precision>(one_of("--precision", text, precision_words));
              });
}

void say(const std::string& text) { std::cerr << "raytree: " + legible(text) + '\n'; }

}  // namespace raytree::cli
