#pragma once

#include <string>

#include "scene/scene.h"

/// Small scenes that tests are made of.
namespace raytree::test {

/// Adds an object with the material at `material` and a default name; returns it.
Object& add(Scene& scene, Shape shape, std::size_t material = 0);

/// Adds a material and returns its place.
std::size_t add_material(Scene& scene, Material material);

/// `count` spheres, polygons, triangles and cones, some transformed, within `scale` of `center`.
Scene random_shapes(int count, unsigned seed, double scale, const Point& center);

/// A camera at (0, 0, 5) that looks at the origin, 90 degrees wide, 1 x 1 pixel: its one ray is
/// the z axis.
Camera one_pixel_camera();

}  // namespace raytree::test
