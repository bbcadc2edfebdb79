#pragma once

#include <string>

#include "tree/ray_tree.h"

namespace raytree {

/// "pixel 320,250 of glass-ball", as every form of a tree is headed.
inline std::string pixel_and_scene(const RayTree<double>& tree) {
    return "pixel " + std::to_string(tree.pixel_i) + "," + std::to_string(tree.pixel_j) +
           (tree.scene_name.empty() ? "" : " of " + tree.scene_name);
}

}  // namespace raytree
