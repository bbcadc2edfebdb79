#pragma once

#include <array>

namespace raytree {

/// An affine transform as it is written: the first three rows of a 4 x 4 matrix, row by row, for
/// column vectors, `p' = M p`; the last row is 0 0 0 1.
using Affine = std::array<std::array<double, 4>, 3>;

}  // namespace raytree
