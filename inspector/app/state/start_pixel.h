#pragma once

#include "state/document.h"

namespace raytree::inspector {

/// The pixel to begin with: on a coarse grid, the one whose tree shows most kinds of rays and of
/// reasons, and of these the one with many rays (but no thicket) nearest to the centre. Looks no
/// longer than a tenth of a second.
Pixel start_pixel(const Document& document);

}  // namespace raytree::inspector
