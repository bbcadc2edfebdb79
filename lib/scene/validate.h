#pragma once

#include <vector>

#include "scene/input_error.h"
#include "scene/scene.h"

namespace raytree {

/// Everything in `scene` that is outside the ranges stated in scene.h or makes no scene: a number
/// that is not finite, a view parallel to `up`, a radius of 0, a polygon whose vertices are
/// collinear or not planar (off the plane by more than 1e-6 of its extent), a singular transform, a
/// name given twice, an object without its material. Empty where all is well. `place` is the JSON
/// pointer that the value has in raytree-scene/1.0; `file` is left empty.
std::vector<Mistake> validate(const Scene& scene);

}  // namespace raytree
