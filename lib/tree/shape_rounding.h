#pragma once

#include "trace/world.h"

namespace raytree {

/// What rounding does at a hit of a shape, the ray taken as exact.
struct ShapeRounding {
    double distance = 0;  ///< from the origin to the surface, measured along the normal
    double point = 0;     ///< of the hit point, once it is put back on the surface
    double normal = 0;    ///< of the unit normal there, the point taken as exact
};

/// The error bound of every formulation of lib/geometry, for a ray from `origin` that meets the
/// primitive at `t` in an arithmetic of this unit roundoff u. With e the extent of the shape's
/// box, r its largest coordinate, a = e + the way from the ray's origin to its middle, and c the
/// condition number of its transform times 8 (1 where it has none):
///
/// | shape | normal | distance |
/// | --- | --- | --- |
/// | sphere | 16 c u | 16 c u a |
/// | cone | 16 c u | c u (64 a + 16 r) |
/// | polygon, triangle | c u (4 + 8 sum of edge products / area) | c u (8 a + 4 r) + e normal |
///
/// and for all of them point = c u (4 r + 4 e + 2 a + 2 t). Of a transformed shape, a is larger by
/// r and the origin's own distance from 0. The figures are counts of roundings, rounded up, after
/// Higham (Accuracy and Stability of Numerical Algorithms, 2nd ed. 2002, ch. 3): of the two-step
/// form for spheres (sphere.h), of the quadratic about the cone's middle without cancellation
/// (cone.h), and of a plane by Newell's normal (plane.h), whose area may be all but lost where the
/// shape is a sliver. tests/tree/shape_rounding_test.cpp and the stress tests hold them against the
/// reference arithmetic.
ShapeRounding rounding_of(const World<Quad>& reference, PrimitiveId id, const Vec3<double>& origin,
                          double t, double unit_roundoff);

}  // namespace raytree
