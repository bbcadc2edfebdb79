#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trace/world.h"
#include "tree/ray_tree.h"

/// How far the numbers of a recorded tree may be from those of the same tree without rounding.
///
/// The bounds are a pass over the recorded tree, not an arithmetic of the tracer: interval and
/// running-error types lose that errors depend on each other, and after a few bounces say nothing.
/// Here every source of rounding is a vector that travels along: at each hit all of them go
/// through the derivative of (origin, direction) -> (point, direction onwards), which is the ray
/// differential of Igehy ("Tracing ray differentials", SIGGRAPH 1999), and new ones are added for
/// the hit's own rounding (Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed. 2002,
/// ch. 2 and 3; for shapes as their headers state it). A bound is the sum of what all sources move
/// a number by, to first order, doubled where a surface is curved. So a mirror corridor's errors
/// grow as they do in truth, and not by a factor a bounce.
namespace raytree {

/// A decision that rounding could have turned.
struct Doubt {
    std::string text;  ///< for people, such as "within 3 ulp of missing ball"
    double ulps = 0;   ///< how far from it, in units in the last place of the largest length there
};

/// Each is a bound of the absolute error; of a vector, that of its length, and so of any component.
struct HitBounds {
    double t = 0, point = 0, normal = 0, cos_incident = 0;
    double sin2_transmitted = 0;  ///< where the hit has it
};

struct RayBounds {
    double origin = 0, direction = 0;
    Rgb<double> weight;
    double attenuation = 0;
    HitBounds hit;  ///< where the ray has one; of a shadow ray `t` alone, of what blocks it
    Rgb<double> ambient, diffuse, specular, intensity;
    double distance = 0;        ///< of a shadow ray's light
    Rgb<double> transmittance;  ///< of a shadow ray
    /// Not empty: the ray is undecided, and the bounds of what follows hold for the way it went.
    std::vector<Doubt> doubts;
};

/// The bounds of each ray of `tree`, by id. The tree was recorded of `world`'s scene in an
/// arithmetic of this unit roundoff. What could have gone either way is found by tracing rays
/// around each recorded one, as far from it as it is uncertain, in the reference arithmetic: where
/// one of them meets something else, the ray is undecided. Where all those twice as far out meet
/// the same in double, that is not asked.
std::vector<RayBounds> error_bounds(const World<double>& world, const World<Quad>& reference,
                                    const RayTree<double>& tree, double unit_roundoff);

}  // namespace raytree
