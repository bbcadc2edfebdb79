#pragma once

#include <span>

#include "geometry/ray.h"

namespace raytree {

/// The supporting plane of a planar shape.
template <class T> struct Plane {
    UnitVec3<T> normal = UnitVec3<T>::of({0, 0, 1});
    Vec3<T> point{};  ///< on it
    T error = 0;      ///< bound on the rounding of a distance from it, near the shape
};

/// Newell's normal of the vertices, not normalised: twice the area of the polygon. Taken relative
/// to the first vertex, so that a polygon far from the origin loses nothing (Sutherland, Sproull &
/// Schumacker, "A characterization of ten hidden-surface algorithms", 1974). Its direction is off
/// by at most u (4 + 8 s / area), s the sum of the products of two edges' lengths: little, unless
/// the polygon is a sliver.
template <class T> Vec3<T> newell_normal(std::span<const Vec3<T>> vertices) {
    Vec3<T> sum(T(0));
    for (std::size_t i = 1; i + 1 < vertices.size(); ++i) {
        sum += outer<T>(vertices[i] - vertices[0], vertices[i + 1] - vertices[0]);
    }
    return sum;
}

/// The plane through the mean of the vertices with Newell's normal, which must not be zero.
template <class T> Plane<T> supporting_plane(std::span<const Vec3<T>> vertices) {
    Vec3<T> from_first(T(0));
    T extent = 0;
    for (const Vec3<T>& vertex : vertices) {
        from_first += vertex - vertices[0];
        extent = max_of(extent, largest_component(vertex));
    }
    const Vec3<T> mean = vertices[0] + from_first / static_cast<T>(vertices.size());
    return {UnitVec3<T>::of(newell_normal(vertices)), mean, 16 * Real<T>::unit_roundoff * extent};
}

/// Where the ray meets the plane: t > 0, or a number that is not (0, negative, infinite) where it
/// does not. From a hit point on another shape that lies in the plane within the error bound, it
/// does not: that would be t = 0. `nearest` and `farthest` are the t at which the ray passes the
/// first and the last vertex of a shape that it is known to meet, and keep a plane seen edge-on
/// from giving anything else. t is off by at most u (8 a + 4 r) + n e along the normal, with `a`
/// the way from the origin to the far side of the shape, r its largest coordinate, e its extent and
/// n the error of the plane's normal, and 4 u t along the ray.
template <class T>
T meet(const Plane<T>& plane, const Ray<T>& ray, Start start, T nearest, T farthest) {
    const T distance = inner(plane.normal, plane.point - ray.origin);
    if (start != Start::anywhere && abs(distance) <= plane.error + 4 * ray.origin_error) {
        return 0;
    }
    const T speed = inner(plane.normal, ray.direction);
    return speed == 0 ? T(0) : min_of(max_of(distance / speed, nearest), farthest);
}

/// The foot of the perpendicular from `origin + t direction` on the plane: off the plane by at most
/// 4 u times the shape's largest coordinate, its extent and the way to its middle together.
template <class T> Vec3<T> point_on(const Plane<T>& plane, const Ray<T>& ray, T t) {
    const Vec3<T> near = along(ray.origin, t, ray.direction);
    return along(near, -inner(plane.normal, near - plane.point), plane.normal.vec());
}

/// The two coordinates that are kept when the axis of the normal's largest component is dropped
/// (the first of equals), in cyclic order.
struct KeptAxes {
    int u = 0;
    int v = 1;
};

template <class T> KeptAxes kept_axes(const Vec3<T>& normal) {
    int dropped = 0;
    for (int axis = 1; axis < 3; ++axis) {
        if (abs(normal[axis]) > abs(normal[dropped])) {
            dropped = axis;
        }
    }
    return {(dropped + 1) % 3, (dropped + 2) % 3};
}

}  // namespace raytree
