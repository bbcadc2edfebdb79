#pragma once

#include <set>
#include <string>

#include "tree/ray_tree.h"

namespace raytree::check {

/// What can be said of a pixel's tree in a few words, each of them so that "pixels where ..." is a
/// sentence: "a refracted ray leaves ball", "the light lamp is behind the surface of floor".
std::set<std::string> features_of(const RayTree<double>& tree);

}  // namespace raytree::check
