#pragma once

#include <array>
#include <vector>

#include "drawing/view.h"
#include "scene/scene.h"

namespace raytree::inspector {

/// A polygon as triangles: convex ones as a fan, all others cut into slices by the crossing rule,
/// so that what is filled is what rays meet, however the outline winds.
std::vector<std::array<Point3, 3>> filled(const Polygon& polygon);

/// The part of a convex outline where n · p is at most `most` (one step of Sutherland & Hodgman,
/// "Reentrant polygon clipping", 1974); empty where there is none.
std::vector<Point3> clipped(const std::vector<Point3>& outline, const Point3& n, double most);

}  // namespace raytree::inspector
