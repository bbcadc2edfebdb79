#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/scene.h"

/// The Neutral File Format of E. Haines, version 3.1: statements of single words and numbers.
namespace raytree {

/// Reads a scene. `size` (width, height in pixels, from 1) replaces the file's resolution, on which
/// the window depends. Warnings ("file: place: text") are added to `warnings`. Throws InputError
/// with line, column and word.
Scene read_nff(std::string_view text, const std::filesystem::path& file,
               std::optional<std::pair<int, int>> size, std::vector<std::string>& warnings);

/// Writes what the format can say of a scene; adds a sentence to `lost` for each thing that it
/// cannot.
std::string write_nff(const Scene& scene, std::vector<std::string>& lost);

}  // namespace raytree
