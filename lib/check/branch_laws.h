#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "check/laws.h"

/// What the mistakes of reflection and of refraction have in common.
namespace raytree::check {

/// `a d + b n`.
inline Vec mixed(const Step& step, double a, double b) {
    return a * step.direction + b * step.normal;
}

/// The tree is that of the right coefficient; what its branch adds is not.
template <RayKind kind, class Change> void share_by(Laws& laws, Change) {
    laws.combine = [](const Place& place, const Step& step, const Terms& terms) {
        Terms changed = terms;
        Terms::Branch& branch = kind == RayKind::reflected ? changed.reflected : changed.refracted;
        branch.coefficient = Change{}(step, branch.coefficient);
        return model::combine(place, step, changed);
    };
}

/// Whether rounding puts the start before or behind the surface decides.
template <RayKind kind> void may_meet_own_start(Laws& laws) {
    laws.may_meet_start[static_cast<std::size_t>(kind)] = true;
}

/// Total reflection does not stop the refracted ray.
inline std::optional<Reason> through_total(const Place& place, const Step& step, RayKind kind,
                                           const Spectrum& weight) {
    Step passing = step;
    passing.cos2_transmitted = 1;
    return model::why_not(place, passing, kind, weight);
}

/// `eta d + (eta c1 - sqrt(k)) n`, with k = 0 under total reflection.
inline Vec grazing_where_total(const Place&, const Step& step) {
    const double eta = step.eta1 / step.eta2;
    return mixed(step, eta, eta * step.cosine() - std::sqrt(std::max(0.0, step.cos2_transmitted)));
}

template <RayKind kind> std::optional<Hit<double>> own_surface(const Place& place, const Step& step,
                                                               Interval<double> interval) {
    if (step.kind == kind && step.leaving != no_primitive) {
        return Hit<double>{0, step.leaving};
    }
    return model::meet(place, step, interval);
}

template <RayKind kind> Vec from_eye(const Place& place, const Step& step, RayKind of) {
    return of == kind ? place.scene().camera.eye : step.point;
}

inline std::optional<Reason> none_of(const Place& place, const Step& step, RayKind kind,
                                     const Spectrum& weight, RayKind which, bool inside_only) {
    const auto reason = model::why_not(place, step, kind, weight);
    const bool stopped = kind == which && (!inside_only || !step.front);
    const Reason why =
        which == RayKind::reflected ? Reason::not_reflective : Reason::not_transmissive;
    return stopped ? std::optional(reason.value_or(why)) : reason;
}

template <RayKind which, bool inside_only>
inline std::optional<Reason> without(const Place& place, const Step& step, RayKind kind,
                                     const Spectrum& weight) {
    return none_of(place, step, kind, weight, which, inside_only);
}

/// Branches of a kind start a little beside the surface, on the wrong side of it: there they meet
/// it again.
template <RayKind kind> void on_the_wrong_side(Laws& laws) {
    laws.offset = [](const Step& step, RayKind of) {
        const Vec way = model::offset(step, of);
        return of == kind ? -way : way;
    };
    laws.start = [](const Place&, const Step& step, RayKind of) {
        const double size = std::max(1.0, largest_component(step.point));
        return of == kind ? along(step.point, -1e-5 * size, model::offset(step, of)) : step.point;
    };
}

}  // namespace raytree::check
