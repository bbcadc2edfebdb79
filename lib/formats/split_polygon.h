#pragma once

#include <vector>

#include "scene/scene.h"

namespace raytree {

/// Triangles that cover a polygon that is not planar, with its vertex normals; those without area
/// are left out. Ears are cut as seen along the polygon's normal, so a concave polygon keeps its
/// outline. The polygon has three or more finite vertices and an area.
std::vector<Polygon> split_into_triangles(const Polygon& polygon);

}  // namespace raytree
