#pragma once

#include <algorithm>
#include <cmath>

#include "check/film.h"
#include "check/light_laws.h"

/// What comes of a primary direction that is not made unit: `P - E`, and formulas that want it
/// unit.
namespace raytree::check {

inline Beam primary_not_unit(const Place& place, const Step& step) {
    return beam_through(place, film_of(place, step));
}

/// The highlight with `V = -d` as long as d is.
inline Spectrum highlight_not_unit(const Place& place, const Step& step, const Shine& shine) {
    return with_viewer(place, step, shine, -step.length * step.direction);
}

/// Snell's law with d as long as it is. Where that takes the root of a negative number, of 0.
inline Vec refracted_not_unit(const Place&, const Step& step) {
    const Vec d = step.length * step.direction;
    const double eta = step.eta1 / step.eta2;
    const double c1 = -inner(d, step.normal);
    const double k = 1 - eta * eta * (1 - c1 * c1);
    return eta * d + (eta * c1 - std::sqrt(std::max(0.0, k))) * step.normal;
}

}  // namespace raytree::check
