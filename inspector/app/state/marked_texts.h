#pragma once

#include <optional>

#include "state/details.h"
#include "state/outline.h"
#include "state/playback.h"

/// Texts of a tree that is being stepped through or compared: what is not known yet is not said,
/// and marks are.
namespace raytree::inspector {

/// The rows of what has happened; null where nothing is stepped through.
Outline::Shown happened_rows(const std::optional<Playback>& playback);

OutlineTexts marked_texts_of(const PixelTree& tree, const OutlineRow& row,
                             const std::optional<Playback>& playback);

/// "#5 refracted ray" with its mark.
std::string marked_title_of(const PixelTree& tree, std::size_t ray);

/// How the ray compares, then its details: those that are known by now; of a tree out of a file
/// what the file says.
std::vector<DetailSection> known_details(const PixelTree& tree, std::size_t ray,
                                         const std::optional<Playback>& playback);

/// Whether it is known by now what the ray meets.
bool is_found(const std::optional<Playback>& playback, std::size_t ray);

/// Whether everything is known of a ray that was traced here, so that it can be worked out anew.
bool can_derive(const PixelTree& tree, std::size_t ray, const std::optional<Playback>& playback);

}  // namespace raytree::inspector
