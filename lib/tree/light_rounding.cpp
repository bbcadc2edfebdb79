#include "tree/light_rounding.h"

#include <algorithm>
#include <cmath>

#include "trace/shading.h"

namespace raytree {
namespace {

using Vec = Vec3<double>;

/// `max(0, cosine)^s`, and how far it may be off where the cosine is, by so much.
struct Power {
    double value = 0, error = 0;
};

Power power_of(double cosine, double off, double s, double u) {
    const auto at = [s](double h) { return std::pow(std::max(0.0, h), s); };
    const double value = at(cosine), more = at(cosine + off), less = at(cosine - off);
    if (cosine + off <= 0) {
        return {value, 0};  // turned away from the viewer for certain
    }
    return {value, std::max(more - value, value - less) + 4 * u * more + 4 * underflow};
}

/// How far the sources of rounding turn the light at a hit, to first order: the way to it, its
/// cosine with the normal, and that of the highlight before it is cut off at 0.
struct Turned {
    double direction = 0, distance = 0, cosine = 0, highlight = 0;
};

Turned turned(const LightSeen& seen, SpecularModel model, const HitNoise& at, double u) {
    const bool phong = model == SpecularModel::phong;
    const Vec& l = seen.towards;
    const Vec v = -at.viewing;
    const Vec& n = at.normal;
    const Vec sum = l + v;
    const double sum_length = std::max(length(sum), 4 * u);
    const Vec half = sum / sum_length;
    const double n_l = inner(n, l), n_v = inner(n, v);
    const double off = total(at.surface, [](const Noise& s) { return length(s.place); });
    if (!seen.light.directional && !(seen.distance > 2 * off)) {
        return {2, off, 2, 2};  // the light may be in any direction
    }
    // Right beside a light, its direction turns more than the first order says.
    const double nearest = seen.distance - off;
    Turned result;
    for (std::size_t k = 0; k < at.surface.size(); ++k) {
        const Vec& dn = at.surface[k].way;
        const Vec dv = -at.direction[k].way;
        Vec dl(0, 0, 0);
        if (!seen.light.directional) {
            dl = across(-at.surface[k].place, l) / nearest;
            result.distance += std::abs(inner(at.surface[k].place, l));
        }
        const double cos_moves = inner(dn, l) + inner(n, dl);
        result.direction += length(dl);
        result.cosine += std::abs(cos_moves);
        result.highlight +=
            std::abs(phong ? 2 * cos_moves * n_v + 2 * n_l * (inner(dn, v) + inner(n, dv)) -
                                 inner(dl, v) - inner(l, dv)
                           : inner(dn, half) + inner(n, across(dl + dv, half)) / sum_length);
    }
    result.highlight += 16 * u / (phong ? 1 : std::min(1.0, sum_length));
    return result;
}

double highlight_cosine(SpecularModel model, const Vec& n, const Vec& l, const Vec& v) {
    const Vec sum = l + v;
    return model == SpecularModel::phong ? inner(mirrored(l, n), v)
           : largest_component(sum) > 0  ? inner(n, UnitVec3<double>::of(sum).vec())
                                         : 0;
}

}  // namespace

double attenuation_error(const WorldAttenuation<double>& f, double t, double t_error, double u) {
    const double value = f.at(t);
    return std::max(f.at(std::max(0.0, t - t_error)) - value, value - f.at(t + t_error)) +
           6 * u * value + underflow;
}

LightRounding light_rounding(const LightSeen& seen, const WorldMaterial<double>& material,
                             SpecularModel model, const HitNoise& at, double u) {
    const WorldLight<double>& light = seen.light;
    const Turned moves = turned(seen, model, at, u);
    LightRounding result;
    result.direction = moves.direction + (light.directional ? 4 : 6) * u;
    result.distance = moves.distance + 6 * u * seen.distance;
    result.cosine = moves.cosine + 6 * u;
    const double n_l = inner(at.normal, seen.towards);
    if (!(n_l > 0)) {
        return result;
    }
    const double g = light.directional ? 1 : light.attenuation.at(seen.distance);
    const double g_error =
        light.directional ? 0
                          : attenuation_error(light.attenuation, seen.distance, result.distance, u);
    const Rgb<double> intensity = absolute(light.intensity);
    const Rgb<double> through = absolute(seen.transmittance);
    const Rgb<double> arriving = g * (intensity * through);
    const Rgb<double> arriving_error = g_error * (intensity * through) +
                                       (g + g_error) * (intensity * seen.transmittance_error) +
                                       rounded(arriving, 6, u);
    const Rgb<double> diffuse = absolute(material.diffuse);
    result.diffuse = result.cosine * (diffuse * arriving) +
                     (n_l + result.cosine) * (diffuse * arriving_error) +
                     rounded(n_l * (diffuse * arriving), 6, u);
    const Power power = power_of(highlight_cosine(model, at.normal, seen.towards, -at.viewing),
                                 moves.highlight, material.shininess, u);
    const Rgb<double> specular = absolute(material.specular);
    const double at_most = power.value + power.error;
    result.specular = power.error * (specular * arriving) + at_most * (specular * arriving_error) +
                      rounded(at_most * (specular * arriving), at_most > 0 ? 6 : 0, u);
    // What is multiplied by 0 is 0.
    const Rgb<double> any = where_any(intensity) * where_any(through + seen.transmittance_error);
    result.diffuse = any * where_any(diffuse) * result.diffuse;
    result.specular = any * where_any(specular) * result.specular;
    return result;
}

}  // namespace raytree
