#pragma once

#include "scene/scene.h"
#include "state/palette.h"

namespace raytree::inspector {

/// How an object looks in the 3D view: mostly its material's colour, glass and mirrors by tints of
/// their own.
struct Coat {
    Ink ink;
    double firmness;  ///< 0 to 1, where a see-through shape is looked at straight on
};
Coat coat_of(const Material& material);

}  // namespace raytree::inspector
