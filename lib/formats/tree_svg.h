#pragma once

#include <string>

#include "tree/ray_tree.h"

namespace raytree {

/// The tree as a diagram, from the primary ray at the top: a box for what each ray hit, with the
/// intensity that it brings; shadow rays and rays that were not sent beside it, with their reasons;
/// a legend. A whole SVG document, on white.
std::string write_tree_svg(const RayTree<double>& tree);

}  // namespace raytree
