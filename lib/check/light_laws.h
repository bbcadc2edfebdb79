#pragma once

#include <cmath>

#include "check/laws.h"
#include "trace/shading.h"

/// What the mistakes of local illumination have in common.
namespace raytree::check {

inline double fading(const Shine& shine) {
    return shine.ready->directional ? 1 : shine.ready->attenuation.at(shine.distance);
}

inline Spectrum arriving(const Shine& shine) {
    return fading(shine) * (shine.ready->intensity * shine.transmittance);
}

inline Vec viewer(const Step& step) { return -step.direction; }

inline double power(double h, double exponent) {
    // Of a negative number, as pow has it for whole exponents.
    return h < 0 ? (std::fmod(std::abs(exponent), 2) == 1 ? -1 : 1) * std::pow(-h, exponent)
                 : std::pow(h, exponent);
}

/// The highlight with another cosine h; where the model has none (n . L <= 0), none.
inline Spectrum highlight(const Step& step, const Shine& shine, double h) {
    return power(h, step.ready->shininess) * (step.ready->specular * arriving(shine));
}

inline double h_of(const Place& place, const Step& step, const Shine& shine) {
    return specular_cosine(place.scene().settings.specular_model, step.normal, shine.towards,
                           viewer(step));
}

/// R . V, not clamped.
inline double mirrored_cosine(const Step& step, const Shine& shine) {
    return inner(mirrored(shine.towards, step.normal), viewer(step));
}

inline Spectrum with_viewer(const Place& place, const Step& step, const Shine& shine,
                            const Vec& v) {
    return highlight(
        step, shine,
        specular_cosine(place.scene().settings.specular_model, step.normal, shine.towards, v));
}

}  // namespace raytree::check
