#pragma once

#include "state/details.h"

namespace raytree::inspector {

/// Whether rounding could have turned the ray's way; known where the tree has its error bounds.
bool in_doubt(const PixelTree& tree, std::size_t ray);

/// Puts beside each number how far it may be from the one without rounding, and says first what
/// could have gone either way. What is exact has no bound; nothing has one where they are not
/// known.
void add_bounds(std::vector<DetailSection>& sections, const PixelTree& tree, std::size_t ray);

}  // namespace raytree::inspector
