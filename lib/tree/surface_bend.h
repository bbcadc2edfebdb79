#pragma once

#include <array>

#include "trace/world.h"

namespace raytree {

/// How a surface's shading normal turns along it, about one of its points.
struct SurfaceBend {
    std::array<Vec3<double>, 2> tangents, turns;
    double curvature = 0;  ///< the larger turn of a unit way, 0 of what is flat

    /// How the normal turns when the point moves by so much.
    Vec3<double> turn(const Vec3<double>& moved) const {
        return inner(tangents[0], moved) * turns[0] + inner(tangents[1], moved) * turns[1];
    }
};

/// The bend where the ray meets the shape at `t` with the geometric normal `n`: by finite
/// differences of the shape's own surface_at, which holds for every kind of shape, transformed or
/// with interpolated normals.
SurfaceBend bend_at(const ShapeSet<double>& shapes, PrimitiveId id, const Ray<double>& ray,
                    double t, const Vec3<double>& n);

/// By how much more than the bend says the normal changes within `reach` of there: where it jumps,
/// as an interpolated one of a concave polygon does beside a vertex. In the reference arithmetic.
double jump_within(const ShapeSet<Quad>& reference, PrimitiveId id, const Ray<double>& ray,
                   double t, const SurfaceBend& bend, double reach);

}  // namespace raytree
