#pragma once

#include <optional>
#include <string>
#include <vector>

#include "state/state.h"

namespace raytree::inspector {

/// A line of the outline: a ray, or in grey one that was not sent.
struct OutlineRow {
    std::size_t ray = 0;                 ///< itself, or the one that it would have been sent from
    std::optional<std::size_t> skipped;  ///< of a ghost: place in that ray's list
    std::size_t parent = 0;              ///< place in Outline::rows; of the first, itself
    std::size_t place = 0;               ///< among its siblings
    std::vector<std::size_t> children;
};

/// The tree as rows for an outline: level by level, the children of a row in the order of
/// computation, ghosts where they would have stood.
struct Outline {
    std::vector<OutlineRow> rows;
    std::vector<std::size_t> row_of_ray;
};

Outline outline_of(const PixelTree& tree, bool ghosts);

/// What the columns say.
struct OutlineTexts {
    std::string ray;        ///< "refracted"; "shadow → key"
    std::string met;        ///< "glass ball, back"; "reaches the light"; "blocked by floor"
    std::string t;
    std::string intensity;  ///< of a shadow ray: what it adds
    std::string ended;      ///< why it went no further, or was not sent
};
OutlineTexts texts_of(const PixelTree& tree, const OutlineRow& row);

/// The colour of a ray's intensity, or of what a shadow ray adds; none for a ghost.
std::optional<Rgb<double>> swatch_of(const PixelTree& tree, const OutlineRow& row);

}  // namespace raytree::inspector
