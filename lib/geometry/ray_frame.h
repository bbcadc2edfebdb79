#pragma once

#include <span>

#include "geometry/ray.h"

namespace raytree {

/// A frame in which the ray is an axis: points are sheared along it on the plane across the axis
/// of its largest component, relative to its origin (Woop, Benthin & Wald, "Watertight ray/triangle
/// intersection", JCGT 2(1), 2013). A vertex has the same place there for every shape that it
/// belongs to, so that shapes which share an edge agree on which side of it the ray passes. A place
/// is off by at most 5 u times the largest component of the way from the origin.
template <class T> struct RayFrame {
    int x = 0, y = 1, z = 2;
    T shear_x{}, shear_y{};

    RayFrame() = default;
    explicit RayFrame(const Vec3<T>& d) {
        z = abs(d.x) > abs(d.y) ? 0 : 1;
        z = abs(d.z) > abs(d[z]) ? 2 : z;
        x = (z + 1) % 3;
        y = (z + 2) % 3;
        shear_x = d[x] / d[z];
        shear_y = d[y] / d[z];
    }

    T x_of(const Vec3<T>& from_origin) const { return from_origin[x] - shear_x * from_origin[z]; }
    T y_of(const Vec3<T>& from_origin) const { return from_origin[y] - shear_y * from_origin[z]; }
};

/// Between which t a ray that meets the convex hull of some points meets it, each off by at most 4
/// u times the largest component of the way to the farthest point.
template <class T> struct Passage { T nearest, farthest; };

template <class T>
Passage<T> passage(std::span<const Vec3<T>> points, const Ray<T>& ray, const RayFrame<T>& frame) {
    T low = points[0][frame.z] - ray.origin[frame.z];
    T high = low;
    for (const Vec3<T>& point : points.subspan(1)) {
        const T z = point[frame.z] - ray.origin[frame.z];
        low = min_of(low, z);
        high = max_of(high, z);
    }
    const T d = ray.direction[frame.z];
    return d > 0 ? Passage<T>{low / d, high / d} : Passage<T>{high / d, low / d};
}

}  // namespace raytree
