#pragma once

#include <optional>

#include "scene/scene.h"
#include "trace/world.h"

/// The formulas of illumination at one hit (model, section 3), each a function of its own. They are
/// made part of the tracer that asks for them, so that they have its instruction set.
namespace raytree {

/// What a light does at a point, before anything in between is asked.
template <class T> struct Illumination {
    Vec3<T> towards{};               ///< L, unit
    T distance = Real<T>::infinity;  ///< D
    T cosine = 0;                    ///< n . L
    bool in_front() const { return cosine > 0; }
};

/// A vector taken apart: what `length` and `UnitVec3::of` say of it, which have their steps in
/// common. It must be finite; of no length, its direction means nothing.
template <class T> struct LengthAndDirection {
    T length;
    Vec3<T> direction;
};

template <class T>
[[gnu::always_inline]] inline LengthAndDirection<T> length_and_direction(const Vec3<T>& v) {
    const T scale = largest_component(v);
    if (can_be_squared(scale)) {
        const T length = sqrt(inner(v, v));
        return {length, v / length};
    }
    if (!(scale > 0)) {
        return {scale, v};
    }
    const Vec3<T> scaled = v / scale;
    const T length = sqrt(inner(scaled, scaled));
    return {scale * length, scaled / length};
}

template <class T>
[[gnu::always_inline]] inline Illumination<T> illuminate(const WorldLight<T>& light,
                                                         const Vec3<T>& point, const Vec3<T>& n) {
    Illumination<T> result;
    if (light.directional) {
        result.towards = light.towards;
    } else {
        const auto [distance, direction] = length_and_direction<T>(light.position - point);
        result.distance = distance;
        if (!(distance > 0)) {
            return result;  // the light is on the point itself: it has no direction
        }
        result.towards = direction;
    }
    result.cosine = inner(n, result.towards);
    return result;
}

/// `2 (n . v) n - v`, for a unit `n`: v mirrored about n.
template <class T>
[[gnu::always_inline]] inline Vec3<T> mirrored(const Vec3<T>& v, const Vec3<T>& n) {
    return along(Vec3<T>(-v), 2 * inner(n, v), n);
}

/// `h` of the specular term: R . V (Phong, 1975) or n . H (Blinn, 1977), at least 0.
template <class T> [[gnu::always_inline]] inline T specular_cosine(SpecularModel model,
                                                                   const Vec3<T>& n,
                                                                   const Vec3<T>& towards_light,
                                                                   const Vec3<T>& towards_viewer) {
    if (model == SpecularModel::phong) {
        return max_of(T(0), inner(mirrored(towards_light, n), towards_viewer));
    }
    const Vec3<T> sum = towards_light + towards_viewer;
    return largest_component(sum) > 0 ? max_of(T(0), inner(n, UnitVec3<T>::of(sum).vec())) : T(0);
}

template <class T> struct LocalLight { Rgb<T> diffuse, specular; };

/// The two terms of a light in front of the surface of which `transmittance` arrives.
template <class T> [[gnu::always_inline]] inline LocalLight<T> local_light(
    SpecularModel model, const WorldMaterial<T>& material, const WorldLight<T>& light,
    const Illumination<T>& at, const Vec3<T>& n, const Vec3<T>& viewing,
    const Rgb<T>& transmittance) {
    const T g = light.directional ? T(1) : light.attenuation.at(at.distance);
    const Rgb<T> arriving = g * (light.intensity * transmittance);
    LocalLight<T> adds{at.cosine * (material.diffuse * arriving), {}};
    if (!is_zero(material.specular)) {
        const T h = specular_cosine(model, n, at.towards, Vec3<T>(-viewing));
        adds.specular = pow(h, material.shininess) * (material.specular * arriving);
    }
    return adds;
}

template <class T>
[[gnu::always_inline]] inline UnitVec3<T> reflected_direction(const Vec3<T>& d, const Vec3<T>& n) {
    return UnitVec3<T>::of(along(d, -2 * inner(d, n), n));
}

/// Snell's law at a hit.
template <class T> struct Snell {
    T eta1 = 1, eta2 = 1;
    T sin2_transmitted = 0;
    T cos2_transmitted = 1;  ///< 1 - sin2_transmitted, to more digits near the critical angle

    bool total_reflection() const { return cos2_transmitted < 0; }

    /// Bound on the error of `cos2_transmitted`, the ray and the normal taken as exact: the cross
    /// product to 3 u, its square to 9 u, the ratio of indices squared to 3 u, their product and
    /// the difference once more each.
    T error() const { return 14 * Real<T>::unit_roundoff * max_of(T(1), sin2_transmitted); }
};

/// sin^2 of the incident angle is |n x d|^2, which keeps its digits near normal incidence.
template <class T>
[[gnu::always_inline]] inline Snell<T> snell(T eta1, T eta2, const Vec3<T>& d, const Vec3<T>& n) {
    const Vec3<T> across = outer(n, d);
    const T sin2 = inner(across, across);
    const T eta = eta1 / eta2;
    return {eta1, eta2, eta * eta * sin2, fma(-(eta * eta), sin2, T(1))};
}

template <class T>
[[gnu::always_inline]] inline UnitVec3<T> refracted_direction(const Snell<T>& snell,
                                                              const Vec3<T>& d, const Vec3<T>& n) {
    const T eta = snell.eta1 / snell.eta2;
    const T cos_incident = -inner(d, n);
    return UnitVec3<T>::of(
        along(Vec3<T>(eta * d), eta * cos_incident - sqrt(snell.cos2_transmitted), n));
}

}  // namespace raytree
