#pragma once

#include "trace/world.h"
#include "tree/ray_noise.h"
#include "tree/ray_tree.h"

namespace raytree {

/// What the rays that leave a hit, and the light at it, need of it: where it is, and how every
/// source of rounding moves it. The two lists have the same sources in the same order.
struct HitNoise {
    PrimitiveId primitive = no_primitive;
    Vec3<double> point{}, normal{}, viewing{};  ///< the normal as shaded, on the ray's side
    bool front = true;
    double speed = 0;     ///< cosine between the ray and the geometric normal, its sign left out
    double t_error = 0;   ///< bound of the error of t
    NoiseList surface;    ///< of the point and the shading normal
    NoiseList direction;  ///< of the ray's direction (`way`)
};

/// The hit of `ray` with the primitive: the ray's noise through the derivative of a hit (Igehy,
/// "Tracing ray differentials", SIGGRAPH 1999), and what the shape's own formulas add.
HitNoise noise_at_hit(const World<double>& world, const World<Quad>& reference, PrimitiveId id,
                      const TreeRay<double>& ray, const NoiseList& noise, double unit_roundoff);

/// The noise of the branch of that hit: through the derivative of reflection or refraction.
NoiseList noise_onwards(const HitNoise& at, const TreeHit<double>& hit,
                        const TreeRay<double>& branch, double unit_roundoff);

/// The noise of the hit's shadow ray.
NoiseList noise_to_light(const HitNoise& at, const TreeRay<double>& shadow_ray,
                         double unit_roundoff);

}  // namespace raytree
