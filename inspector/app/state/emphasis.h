#pragma once

#include <vector>

#include "state/state.h"

namespace raytree::inspector {

/// Of each ray of the tree, whether the 3D view fades it: because the filter dims it, or because
/// it has nothing to do with what is selected: a ray with its ancestors and children, an object
/// with the rays that meet it, a light with those sent to it. There must be a tree.
std::vector<bool> set_aside(const State& state);

/// How lists and drawings of the tree show its rays, by their numbers; empty where none is so.
struct Emphasis {
    std::vector<bool> faded;   ///< the filter dims or hides it in the 3D view
    std::vector<bool> marked;  ///< it has to do with the object or light that is selected
};
Emphasis emphasis_of(const State& state);

}  // namespace raytree::inspector
