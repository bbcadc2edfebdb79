#pragma once

#include "check/finding.h"
#include "check/picture_values.h"

namespace raytree::check {

/// Of so many pixels of all something holds, which `reason` says.
Finding of_pixels(std::string reason, std::size_t pixels, std::size_t all);
/// "12,7"
std::string pixel_text(PixelPlace at);

/// What the trees of the pixels that differ have in common and those of the others have not, the
/// largest group first. `all`: pixels of the picture.
std::vector<Finding> groups_of_pixels(const Rulebook& book,
                                      const std::vector<PixelPlace>& differing,
                                      const std::vector<PixelPlace>& agreeing, std::size_t all);

}  // namespace raytree::check
