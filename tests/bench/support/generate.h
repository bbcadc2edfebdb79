#pragma once

#include <string>
#include <vector>

#include "accel/intersector.h"
#include "scene/scene.h"

/// Scenes of any size and the rays to try on them, the same for the same arguments. All
/// coordinates are floats, so that every program is given the same scene.
namespace raytree::bench {

/// The names that `generate` knows: terrain, atrium, gears (triangles), balls (spheres), rings
/// (spheres and cylinders).
const std::vector<std::string>& generated_names();

/// About `shapes` shapes, a camera that sees most of them, and a light.
Scene generate(const std::string& name, std::size_t shapes);

/// How many shapes a ray can meet.
std::size_t shape_count(const Scene& scene);

enum class RayOrder { coherent, diffuse, random };
inline constexpr RayOrder ray_orders[] = {RayOrder::coherent, RayOrder::diffuse, RayOrder::random};
std::string name_of(RayOrder order);

/// About `count` rays, their numbers floats. Coherent: the camera's, in blocks of 4 x 4 pixels;
/// for `any` those from their hits to the light. Diffuse: from these hits in random directions.
/// Random: between random points of the scene's box; for `closest` they go on for ever.
std::vector<Query<double>> make_rays(const Scene& scene, const Intersector<double>& shapes,
                                     RayOrder order, bool any, std::size_t count);

}  // namespace raytree::bench
