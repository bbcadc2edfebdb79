#pragma once

#include <array>
#include <cstdint>

#include "math/vector.h"

namespace raytree {

/// The place of a shape in the scene's list of primitives: objects in their order, a mesh's
/// triangles one by one.
using PrimitiveId = std::uint32_t;
inline constexpr PrimitiveId no_primitive = 0xffff'ffff;

/// To which side of the surface that it starts on a ray goes, where whoever sends it knows: a
/// reflected ray to the side it came from, a refracted one to the other. At grazing angles the
/// numbers do not tell.
enum class Going { unknown, outwards, inwards };

/// A half line `origin + t direction`, t > 0. In the world the direction is a unit vector and t a
/// distance; in the own space of a transformed shape t is still the distance in the world.
template <class T> struct Ray {
    Vec3<T> origin{};
    Vec3<T> direction{};
    T origin_error = 0;  ///< how far rounding may have moved the origin, in the space's own unit
    Going going = Going::unknown;
};

/// What is known of a ray's start. It decides whether an intersection near t = 0 is one.
enum class Start {
    anywhere,          ///< in free space: every t > 0 counts
    on_another_shape,  ///< on a computed hit point: this shape may pass through it by touching
    on_this_shape,     ///< on a computed hit point of this very shape
};

/// Up to two intersections of a ray with a shape, in ascending order of t; each t > 0 and finite.
template <class T> struct Roots {
    int count = 0;
    std::array<T, 2> t{};

    /// Adds `root` where it is one that a ray can meet. Roots are to be added in ascending order.
    void add(T root) {
        if (root > 0 && root < Real<T>::infinity) {
            t[static_cast<std::size_t>(count++)] = root;
        }
    }
};

/// A point on a surface and its two unit normals: the geometric one, outward or on the front side,
/// and the one that shading uses, on the same side (equal where nothing is interpolated).
template <class T> struct SurfacePoint {
    Vec3<T> point;
    UnitVec3<T> geometric_normal;
    UnitVec3<T> shading_normal;
};

}  // namespace raytree
