#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"

/// The text format of several universities' ray tracing courses: one statement a line.
namespace raytree {

struct CourseScene {
    Scene scene;
    std::optional<std::string> output;  ///< the last part of the name that OUTPUT gives
};

/// Reads a scene. Throws InputError with line, column and word.
CourseScene read_course_text(std::string_view text, const std::filesystem::path& file);

/// Writes what the format can say of a scene: spheres and ellipsoids, seen from the camera. Adds a
/// sentence to `lost` for each thing that it cannot. `output` is the picture's name.
std::string write_course_text(const Scene& scene, const std::string& output,
                              std::vector<std::string>& lost);

}  // namespace raytree
