#pragma once

#include "geometry/ray.h"

namespace raytree {

template <class T> struct SphereShape {
    Vec3<T> center{};
    T radius = 1;
};

/// The intersections with a sphere. The ray's origin is first moved to the point nearest to the
/// centre, so that no digits are lost however far away it starts (the two-step form of Haines,
/// Günther & Akenine-Möller, "Precision improvements for ray/sphere intersection", Ray Tracing Gems
/// ch. 7, 2019). From a start on the sphere the other root is -2 (f . d) / (d . d), none where the
/// ray goes outwards; a chord too short for its sign to be known is one unit roundoff of the
/// radius. What rounding does to a root, sphere_error.h says: along the normal at most 16 u times
/// the way from the origin to the far side.
template <class T>
Roots<T> intersect(const SphereShape<T>& sphere, const Ray<T>& ray, Start start) {
    const Vec3<T> f = ray.origin - sphere.center;
    const Vec3<T>& d = ray.direction;
    const T a = inner(d, d);
    const T first_step = -inner(f, d) / a;
    Roots<T> roots;
    if (start == Start::on_another_shape) {
        const T reach = largest_component(sphere.center) + sphere.radius;
        const T error = 4 * (ray.origin_error + 4 * Real<T>::unit_roundoff * reach);
        const T off_surface = inner(f, f) - sphere.radius * sphere.radius;
        if (abs(off_surface) <= 2 * sphere.radius * error) {
            roots.add(2 * first_step);
            return roots;
        }
    }
    if (start == Start::on_this_shape) {
        if (ray.going == Going::inwards) {
            roots.add(max_of(2 * first_step, Real<T>::unit_roundoff * sphere.radius));
        } else if (ray.going == Going::unknown) {
            roots.add(2 * first_step);
        }
        return roots;
    }
    const Vec3<T> foot = along(f, first_step, d);
    const T second_step = -inner(foot, d) / a;
    const Vec3<T> in_radii = foot / sphere.radius;
    const T square = 1 - inner(in_radii, in_radii);
    if (square < 0) {
        return roots;
    }
    const T half_chord = sphere.radius * sqrt(square / a);
    roots.add(first_step + (second_step - half_chord));
    if (half_chord > 0) {
        roots.add(first_step + (second_step + half_chord));
    }
    return roots;
}

/// The point of the sphere nearest to `origin + t direction`: off the sphere by at most
/// u (4 radius + 2 |center|). The normal there is off by at most u (4 + 2 (|origin - center| + t) /
/// radius), `t` taken as exact.
template <class T>
SurfacePoint<T> surface_at(const SphereShape<T>& sphere, const Ray<T>& ray, T t) {
    const Vec3<T> f = ray.origin - sphere.center;
    const auto normal = UnitVec3<T>::of(along(f, t, ray.direction));
    return {along(sphere.center, sphere.radius, normal.vec()), normal, normal};
}

}  // namespace raytree
