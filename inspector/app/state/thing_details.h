#pragma once

#include <string>
#include <vector>

#include "state/details.h"
#include "state/thing.h"

namespace raytree::inspector {

/// "glass ball" and "light key": what a thing is called in headings.
std::string title_of(const Scene& scene, Thing thing);

/// An object with its shape, its material, and the rays of the tree that meet it; or a light with
/// the rays that are sent to it. `tree` may be null.
std::vector<DetailSection> details_of(const Scene& scene, const PixelTree* tree, Thing thing);

/// Of the rays of a thing, no more than this many are listed.
inline constexpr std::size_t most_listed = 40;

}  // namespace raytree::inspector
