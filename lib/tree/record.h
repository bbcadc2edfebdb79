#pragma once

#include "trace/world.h"
#include "tree/ray_tree.h"

namespace raytree {

/// The ray tree of pixel (i, j): column from the left, row from the top. Throws InputError where
/// the pixel lies outside the picture or an intensity grows out of range. `scene_sha256` of the
/// result is left empty.
template <class T> RayTree<T> record_tree(const World<T>& world, int i, int j);

}  // namespace raytree
