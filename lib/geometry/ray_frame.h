#pragma once

#include <array>
#include <cstddef>
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
        // Products in place of branches: which axis it is no processor can guess.
        const int x_or_y = abs(d.x) > abs(d.y) ? 0 : 1;
        const int is_z = abs(d.z) > max_of(abs(d.x), abs(d.y)) ? 1 : 0;
        z = x_or_y * (1 - is_z) + 2 * is_z;
        x = axes_in_turn[static_cast<std::size_t>(z + 1)];
        y = axes_in_turn[static_cast<std::size_t>(z + 2)];
        shear_x = component(d, x) / component(d, z);
        shear_y = component(d, y) / component(d, z);
    }

    T x_of(const Vec3<T>& from_origin) const {
        return component(from_origin, x) - shear_x * component(from_origin, z);
    }
    T y_of(const Vec3<T>& from_origin) const {
        return component(from_origin, y) - shear_y * component(from_origin, z);
    }

  private:
    static constexpr std::array<int, 5> axes_in_turn = {0, 1, 2, 0, 1};
};

/// Between which t a ray that meets the convex hull of some points meets it, each off by at most 4
/// u times the largest component of the way to the farthest point.
template <class T> struct Passage {
    T nearest, farthest;

    /// Between two places along an axis, seen from the origin, by the direction's component there.
    static Passage between(T low, T high, T d) {
        return d > 0 ? Passage{low / d, high / d} : Passage{high / d, low / d};
    }
};

template <class T>
Passage<T> passage(std::span<const Vec3<T>> points, const Ray<T>& ray, const RayFrame<T>& frame) {
    const T origin = component(ray.origin, frame.z);
    T low = component(points[0], frame.z) - origin;
    T high = low;
    for (const Vec3<T>& point : points.subspan(1)) {
        const T z = component(point, frame.z) - origin;
        low = min_of(low, z);
        high = max_of(high, z);
    }
    return Passage<T>::between(low, high, component(ray.direction, frame.z));
}

}  // namespace raytree
