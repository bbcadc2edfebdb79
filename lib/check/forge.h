#pragma once

#include "check/laws.h"
#include "tree/ray_tree.h"

namespace raytree::check {

/// The tree that a program with these laws would give for pixel (i, j). With `model_laws()` it is
/// that of `record_tree`. Throws InputError where an intensity grows out of range.
RayTree<double> forge_tree(const Place& place, const Laws& laws, int i, int j);

}  // namespace raytree::check
