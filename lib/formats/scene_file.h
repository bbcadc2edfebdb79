#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scene/scene.h"

namespace raytree {

enum class SceneFormat { json, nff, course_text, obj };

/// How a scene file is to be read, and what overrides what it says.
struct SceneOptions {
    std::optional<SceneFormat> format;        ///< none: by the file name's extension
    std::optional<std::pair<int, int>> size;  ///< width, height
    std::optional<int> max_depth;
    std::optional<double> min_weight;
    std::optional<double> max_distance;
};

struct LoadedScene {
    Scene scene;
    SceneFormat format = SceneFormat::json;
    std::string sha256;                 ///< of the file's bytes, 64 hexadecimal digits
    std::vector<std::string> warnings;  ///< for people, one sentence each, "file: place: ..."
    std::optional<std::string> output;  ///< the picture's name that a course text file gives
};

/// Reads, overrides and validates a scene. Throws InputError with every mistake that it found.
LoadedScene load_scene(const std::filesystem::path& file, const SceneOptions& options = {});

/// Makes the names of mesh files, which are relative to the folder `from`, relative to `to`, where
/// the scene is to be written.
void relocate_meshes(Scene& scene, const std::filesystem::path& from,
                     const std::filesystem::path& to);

/// Writes the scene in the format that the extension says, as far as that format can say it;
/// returns a sentence for each thing that it cannot. The file is written whole or not at all.
std::vector<std::string> save_scene(const Scene& scene, const std::filesystem::path& file);

}  // namespace raytree
