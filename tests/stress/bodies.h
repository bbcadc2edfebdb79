#pragma once

#include "scene/scene.h"
#include "stress.h"

/// Bodies to shoot rays at.
namespace raytree::stress {

/// Adds an object with a default name and material 0, which is made if there is none.
Object& add(Scene& scene, Shape shape);

/// A closed mesh about `center`: each vertex of a subdivided octahedron at a distance from it of
/// `size` times 1 - roughness to 1. Roughness 0 gives a convex body.
Mesh rough_ball(Random& random, const Point& center, double size, int subdivisions,
                double roughness);

/// A closed double fan of needles: `spokes` triangles from either of two tips to a thin rim.
Mesh needle_fan(const Point& center, double size, int spokes, double tip_height);

/// A closed ball of slivers: `slices` meridians and a few parallels, so thin that an edge is up to
/// thousands of times as long as another.
Mesh sliver_ball(const Point& center, double size, int slices);

/// A rotation with scales between 1 / stretch and stretch, and a translation.
Affine stretched(Random& random, double scale, double stretch, const Point& translation);

}  // namespace raytree::stress
