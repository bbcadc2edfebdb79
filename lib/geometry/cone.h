#pragma once

#include "geometry/ray.h"

namespace raytree {

/// The lateral surface of a cone frustum or cylinder: the points at height z over the base,
/// 0 <= z <= height, whose distance from the axis is `base_radius + slope z`.
template <class T> struct ConeShape {
    Vec3<T> base{};
    UnitVec3<T> axis = UnitVec3<T>::of({0, 0, 1});
    T height = 1;
    T base_radius = 1;
    T slope = 0;
    T error = 0;  ///< bound on the rounding of the shape's own coordinates
};

template <class T>
ConeShape<T> make_cone(const Vec3<T>& base, T base_radius, const Vec3<T>& apex, T apex_radius) {
    const T height = length<T>(apex - base);
    const T extent =
        max_of(largest_component(base), largest_component(apex)) + max_of(base_radius, apex_radius);
    return {base,        UnitVec3<T>::of(apex - base),         height,
            base_radius, (apex_radius - base_radius) / height, 8 * Real<T>::unit_roundoff * extent};
}

/// A vector relative to the base, split along and across the axis.
template <class T> struct AxisParts {
    T z;
    Vec3<T> across;
};

template <class T> AxisParts<T> split(const ConeShape<T>& cone, const Vec3<T>& from_base) {
    const T z = inner(cone.axis, from_base);
    const Vec3<T> across = along(from_base, -z, cone.axis.vec());
    const T rest = inner(cone.axis, across);  // what rounding has left of it along the axis
    return {z + rest, along(across, -rest, cone.axis.vec())};
}

/// The coefficients of the quadratic `a t^2 + 2 b t + c = 0` for a ray that starts at `from_base`.
template <class T> struct ConeQuadratic {
    T a, b, c;
    T z, dz;  ///< height of the start, and its growth with t
};

template <class T>
ConeQuadratic<T> quadratic(const ConeShape<T>& cone, const Vec3<T>& from_base, const Vec3<T>& d) {
    const AxisParts<T> o = split(cone, from_base);
    const AxisParts<T> v = split(cone, d);
    const T radius = fma(cone.slope, o.z, cone.base_radius);
    const T growth = cone.slope * v.z;
    const T off_axis = sqrt(inner(o.across, o.across));
    return {inner(v.across, v.across) - growth * growth,
            inner(v.across, o.across) - growth * radius, (off_axis - radius) * (off_axis + radius),
            o.z, v.z};
}

/// Whether a point at `from_base` is on the surface, up to `error`.
template <class T> bool on_surface(const ConeShape<T>& cone, const Vec3<T>& from_base, T error) {
    const AxisParts<T> p = split(cone, from_base);
    const T radius = fma(cone.slope, p.z, cone.base_radius);
    return abs(sqrt(inner(p.across, p.across)) - radius) <= error * (1 + abs(cone.slope)) &&
           p.z >= -error && p.z <= cone.height + error;
}

/// The intersections with the lateral surface, its two ends included. The origin is first moved
/// near the shape, as for a sphere; the roots are found without cancellation (q = b + sign(b)
/// sqrt(b^2 - a c), c / q and q / a: Press et al., Numerical Recipes, eq. 5.6.4). From a start on
/// the surface the other root is -2 b / a; there is none for a ray that goes outwards, and b < 0
/// for one that goes inwards, whatever rounding has made of it. A root is off by at most
/// u (64 a + 16 r) along the normal, with `a` the way from the origin to the far side of the shape
/// and r its largest coordinate, and 4 u t along the ray.
template <class T> Roots<T> intersect(const ConeShape<T>& cone, const Ray<T>& ray, Start start) {
    const Vec3<T> f = ray.origin - cone.base;
    const Vec3<T>& d = ray.direction;
    Roots<T> roots;
    Going going = Going::unknown;
    if (start == Start::on_this_shape) {
        going = ray.going;
    } else if (start == Start::on_another_shape &&
               on_surface(cone, f, 4 * (ray.origin_error + cone.error))) {
        start = Start::on_this_shape;
    }
    if (going == Going::outwards) {
        return roots;
    }
    if (start == Start::on_this_shape) {
        const ConeQuadratic<T> q = quadratic(cone, f, d);
        const T b = going == Going::inwards ? -abs(q.b) : q.b;
        const T t = -2 * b / q.a;
        const T z = fma(t, q.dz, q.z);
        if (z >= 0 && z <= cone.height) {
            roots.add(t);
        }
        return roots;
    }
    const Vec3<T> from_middle = along(f, -cone.height / 2, cone.axis.vec());
    const T step = -inner(from_middle, d) / inner(d, d);
    const ConeQuadratic<T> q = quadratic(cone, along(f, step, d), d);
    const T square = difference_of_products(q.b, q.b, q.a, q.c);
    if (square < 0) {
        return roots;
    }
    const T pivot = -(q.b + (q.b < 0 ? -sqrt(square) : sqrt(square)));
    const T candidates[2] = {q.c / pivot, pivot / q.a};
    const bool in_order = candidates[0] < candidates[1];
    for (int k = 0; k < 2; ++k) {
        const T t = candidates[(k == 0) == in_order ? 0 : 1];
        const T z = fma(t, q.dz, q.z);
        if (isfinite(t) && z >= 0 && z <= cone.height && !(k == 1 && square == 0)) {
            roots.add(step + t);
        }
    }
    return roots;
}

/// The point of the surface nearest to `origin + t direction`; the normal points away from the
/// axis, and along it at the tip of a cone, where it has no other direction. The point is off the
/// surface by at most 8 u times the largest coordinate and the extent of the shape together.
template <class T> SurfacePoint<T> surface_at(const ConeShape<T>& cone, const Ray<T>& ray, T t) {
    const Vec3<T> from_base = along(Vec3<T>(ray.origin - cone.base), t, ray.direction);
    const AxisParts<T> p = split(cone, from_base);
    const T off_axis = sqrt(inner(p.across, p.across));
    if (!(off_axis > 0)) {
        const UnitVec3<T> normal = cone.slope > 0 ? -cone.axis : cone.axis;
        return {cone.base + from_base, normal, normal};
    }
    const auto normal =
        UnitVec3<T>::of(along(Vec3<T>(p.across / off_axis), -cone.slope, cone.axis.vec()));
    const T gap =
        (off_axis - fma(cone.slope, p.z, cone.base_radius)) / sqrt(1 + cone.slope * cone.slope);
    return {cone.base + along(from_base, -gap, normal.vec()), normal, normal};
}

}  // namespace raytree
