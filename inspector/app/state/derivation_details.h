#pragma once

#include <vector>

#include "state/details.h"
#include "tree/derivation.h"

namespace raytree::inspector {

/// How the ray's hit was found, what else it would have met, and the media that it is in.
std::vector<DetailSection> derivation_details(const Derivation& derivation);

/// Of the shapes along a ray, no more than this many are listed.
inline constexpr std::size_t most_met = 12;

}  // namespace raytree::inspector
