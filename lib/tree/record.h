#pragma once

#include <stop_token>

#include "scene/progress.h"
#include "trace/world.h"
#include "tree/ray_tree.h"

namespace raytree {

/// The ray tree of pixel (i, j): column from the left, row from the top. Throws InputError where
/// the pixel lies outside the picture or an intensity grows out of range. `scene_sha256` of the
/// result is left empty. Throws Stopped soon after a stop has been asked for.
template <class T>
RayTree<T> record_tree(const World<T>& world, int i, int j, const std::stop_token& stop = {});

}  // namespace raytree
