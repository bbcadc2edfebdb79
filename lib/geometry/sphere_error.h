#pragma once

#include "geometry/sphere.h"

/// How far rounding may take the two-step intersection of sphere.h from the exact one: a running
/// error analysis of its operations one after the other (u: the unit roundoff; Higham, Accuracy and
/// Stability of Numerical Algorithms, 2nd ed. 2002, ch. 2 and 3). The ray and the sphere are taken
/// as exact.
namespace raytree {

/// The line of a ray and a sphere, in lengths of the space they are in.
template <class T> struct SphereApproach {
    T away;      ///< from the ray's origin to the centre
    T off_line;  ///< from the ray's line to the centre
    T square;    ///< 1 - (off_line / radius)^2: negative where the line passes by
    T error;     ///< bound on the error of `square`
};

/// With u the unit roundoff, f the way from the centre to the origin and h that to the line: the
/// subtraction moves the sphere by u |f|; the foot of the perpendicular is rounded by u h and
/// slides along the line by 8 u |f|, which counts squared; the product and the difference add 6 u.
template <class T> SphereApproach<T> approach(const SphereShape<T>& sphere, const Ray<T>& ray) {
    constexpr T u = Real<T>::unit_roundoff;
    const Vec3<T> f = ray.origin - sphere.center;
    const T a = inner(ray.direction, ray.direction);
    const Vec3<T> foot = along(f, -inner(f, ray.direction) / a, ray.direction);
    const T away = length(f) / sphere.radius;
    const T off = length(foot) / sphere.radius;
    const T moved = u * (away + 2 * off);
    const T slid = 8 * u * away;
    return {away * sphere.radius, off * sphere.radius, (1 - off) * (1 + off),
            2 * off * moved + 6 * u * off * off + 2 * (moved * moved + slid * slid) + u};
}

/// Bound on the error of a root, where there is one: that of the half chord, of which the square is
/// as uncertain as said, and that of the way to its middle.
template <class T>
T root_error(const SphereShape<T>& sphere, const SphereApproach<T>& at, T speed, T t) {
    constexpr T u = Real<T>::unit_roundoff;
    const T half = at.square > at.error ? at.error / sqrt(at.square) : sqrt(2 * at.error);
    const T length = sphere.radius * half + u * (at.away + 8 * at.off_line + 4 * sphere.radius);
    return length / speed + 4 * u * abs(t);
}

}  // namespace raytree
