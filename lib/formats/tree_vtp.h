#pragma once

#include <string>

#include "tree/ray_tree.h"

namespace raytree {

/// The tree as VTK XML PolyData, for ParaView and its like: a line from each ray's origin to its
/// hit, of a shadow ray to the light or to what blocks it. A ray that meets nothing is a quarter as
/// long as the scene is large, as far as the tree knows the scene: by its hits and the eye. A
/// directional light's shadow ray likewise.
///
/// Cell data: `id`; `parent`, -1 for the primary ray; `kind` and `termination`, the places of their
/// words in the field data `kinds` and `terminations`, -1 for none; `level`; `blocked`, 1 for a
/// shadow ray whose light does not arrive; `weight` and `intensity` in three components, the
/// latter of a shadow ray being what the light adds.
std::string write_tree_vtp(const RayTree<double>& tree);

}  // namespace raytree
