#pragma once

#include <cstddef>

#include "scene/scene.h"

namespace raytree {

/// What tracing a scene takes, known before a ray is traced. Only materials that some object has
/// count, and lights only where some surface is lit.
struct Plan {
    /// Shapes that a ray can meet, by kind.
    std::size_t spheres = 0, polygons = 0, cones = 0;
    std::size_t meshes = 0, triangles = 0;  ///< meshes, and their triangles
    std::size_t point_lights = 0, directional_lights = 0;
    std::size_t materials = 0;  ///< that some object has

    bool reflective = false;            ///< kr is not 0 somewhere
    bool transmissive = false;          ///< kt is not 0 somewhere: refraction, media
    bool lit = false;                   ///< there is a light, and kd or ks is not 0 somewhere
    bool specular = false;              ///< lit, and ks is not 0 somewhere
    bool shadow_rays = false;           ///< lit, and shadows are asked for
    bool shadows_through = false;       ///< shadow rays that pass through what is transmissive
    bool light_attenuated = false;      ///< lit by a light that weakens with distance
    bool attenuated = false;            ///< reflected or refracted rays weaken with distance
    bool interpolated_normals = false;  ///< some shape has vertex normals
    bool transforms = false;            ///< some shape is met in a space of its own
    bool near_plane = false;            ///< primary rays do not see what is near
    bool path_limited = false;          ///< there is a max_distance

    std::size_t lights() const { return point_lights + directional_lights; }
    std::size_t shapes() const { return spheres + polygons + cones + triangles; }
    /// Whether a ray can have a branch at all.
    bool branches() const { return reflective || transmissive; }
};

Plan plan_of(const Scene& scene);

/// `(m + 1)(2^n - 1)`, the rays of a full tree of n = max_depth levels under m lights.
double full_tree_rays(const Scene& scene);

}  // namespace raytree
