#pragma once

#include <cstddef>

#include "scene/scene.h"

namespace raytree::inspector {

/// A mesh of `most` triangles or fewer that looks like this one from afar: vertices in the same
/// cell of a grid become one, with the mean of their triangles' normals, weighted by area.
/// (Rossignac and Borrel, Multi-resolution 3D approximations for rendering complex scenes, 1993.)
raytree::Mesh thinned(const raytree::Mesh& mesh, std::size_t most);

}  // namespace raytree::inspector
