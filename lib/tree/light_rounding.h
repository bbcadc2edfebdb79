#pragma once

#include <cmath>
#include <limits>

#include "trace/world.h"
#include "tree/hit_noise.h"

/// What rounding does to the light at a hit.
namespace raytree {

/// The least that is not 0: what one product below the range of normal numbers may be off by,
/// however small it is (Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed. 2002,
/// sec. 2.2).
inline constexpr double underflow = std::numeric_limits<double>::denorm_min();

inline Rgb<double> absolute(const Rgb<double>& c) {
    return {std::abs(c.r), std::abs(c.g), std::abs(c.b)};
}

/// `s` times a colour's absolute values.
inline Rgb<double> scaled(const Rgb<double>& c, double s) { return std::abs(s) * absolute(c); }

/// 1 where a channel is not 0.
inline Rgb<double> where_any(const Rgb<double>& c) {
    const auto any = [](double x) { return x != 0 ? 1.0 : 0.0; };
    return {any(c.r), any(c.g), any(c.b)};
}

/// What so many roundings of factors that are no larger than 1 do to a product.
inline Rgb<double> rounded(const Rgb<double>& c, double roundings, double unit_roundoff) {
    return scaled(c, roundings * unit_roundoff) + Rgb<double>(roundings * underflow);
}

/// How far `min(1, 1 / (a + b t + c t^2))` may be off where t is, by so much.
double attenuation_error(const WorldAttenuation<double>& f, double t, double t_error,
                         double unit_roundoff);

/// Bounds of the errors of what a light does at a hit: of the unit vector to it, the distance, the
/// cosine with the normal, and the two terms that it adds.
struct LightRounding {
    double direction = 0, distance = 0, cosine = 0;
    Rgb<double> diffuse, specular;
};

/// A light as seen from a hit.
struct LightSeen {
    const WorldLight<double>& light;
    Vec3<double> towards{};
    double distance = 0;        ///< of a point light
    Rgb<double> transmittance;  ///< what of it comes through
    Rgb<double> transmittance_error{};
};

LightRounding light_rounding(const LightSeen& seen, const WorldMaterial<double>& material,
                             SpecularModel model, const HitNoise& at, double unit_roundoff);

}  // namespace raytree
