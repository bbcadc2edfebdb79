#pragma once

#include <string>

#include "tree/ray_tree.h"

namespace raytree {

/// The tree as a Graphviz digraph: a node for each ray and for each one that was not sent.
std::string write_tree_dot(const RayTree<double>& tree);

}  // namespace raytree
