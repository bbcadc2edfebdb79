#pragma once

#include <vector>

#include "geometry/plane.h"

namespace raytree {

/// A planar polygon, convex or concave, prepared for intersection.
template <class T> struct PolygonShape {
    /// A vertex in the two axes kept.
    struct Flat {
        T u, v;
    };

    Plane<T> plane;
    KeptAxes axes;
    std::vector<Flat> outline;
    std::vector<Vec3<T>> normals;  ///< unit, one for each vertex, or none
};

/// `vertices`: three or more; `normals`: none or as many, of any length but 0.
template <class T>
PolygonShape<T> make_polygon(std::span<const Vec3<T>> vertices, std::span<const Vec3<T>> normals);

/// Whether the point lies inside by the crossing (even-odd) rule. An edge is always evaluated from
/// its lower end to its upper, so that two polygons that share it agree on which side the point is.
template <class T> bool inside(const PolygonShape<T>& polygon, T u, T v) {
    bool odd = false;
    const auto& outline = polygon.outline;
    for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
        if ((outline[i].v > v) == (outline[j].v > v)) {
            continue;
        }
        const bool upwards = outline[i].v > outline[j].v;
        const auto& low = upwards ? outline[j] : outline[i];
        const auto& high = upwards ? outline[i] : outline[j];
        const T left_of =
            difference_of_products(high.u - low.u, v - low.v, u - low.u, high.v - low.v);
        odd = odd != (left_of > 0);
    }
    return odd;
}

template <class T>
Roots<T> intersect(const PolygonShape<T>& polygon, const Ray<T>& ray, Start start) {
    Roots<T> roots;
    if (start == Start::on_this_shape) {
        return roots;
    }
    const T t = meet(polygon.plane, ray, start);
    if (!(t > 0) || !isfinite(t)) {
        return roots;
    }
    const auto [u, v] = polygon.axes;
    if (inside(polygon, fma(t, ray.direction[u], ray.origin[u]),
               fma(t, ray.direction[v], ray.origin[v]))) {
        roots.add(t);
    }
    return roots;
}

/// The normal interpolated bilinearly at a point inside: along the two edges that the line of
/// constant second coordinate meets next on either side, then between these two crossings
/// (Phong, "Illumination for computer generated pictures", 1975, for polygons). Unit.
template <class T>
UnitVec3<T> interpolated_normal(const PolygonShape<T>& polygon, const Vec3<T>& point);

template <class T>
SurfacePoint<T> surface_at(const PolygonShape<T>& polygon, const Ray<T>& ray, T t) {
    const Vec3<T> point = point_on(polygon.plane, ray, t);
    return {point, polygon.plane.normal,
            polygon.normals.empty() ? polygon.plane.normal : interpolated_normal(polygon, point)};
}

}  // namespace raytree
