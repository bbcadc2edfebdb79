#pragma once

#include <vector>

#include "state/document.h"

namespace raytree::inspector {

/// Pixels around the chosen one whose trees are shown beside its own.
enum class Neighbours { none, square, row, column };

/// Those of them that lie in the picture: the eight around it; or four on each side of it, in its
/// row or its column. Without the pixel itself.
std::vector<Pixel> neighbours_of(Pixel pixel, Neighbours which, const Camera& camera);

}  // namespace raytree::inspector
