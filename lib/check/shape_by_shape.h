#pragma once

#include <algorithm>

#include "check/laws.h"

/// Intersection as a student's own formula for one shape has it: what a ray meets, and what stands
/// between a hit and a light.
namespace raytree::check {

using Found = std::optional<Hit<double>>;
using Roots2 = Roots<double>;

constexpr std::size_t most_shapes = 600;  // beyond which shapes are not tried one by one

inline Ray<double> ray_of(const Step& step) {
    return {step.origin, step.direction, model::origin_error(step.origin)};
}

inline bool nearer(const Hit<double>& a, const Hit<double>& b) { return a < b; }

/// The model's roots of one shape.
inline Roots2 roots_of(const Place& place, const Step& step, PrimitiveId id) {
    return place.shapes.shapes().intersect(id, ray_of(step), step.leaving);
}

/// Whether a ray meets the shape at most once.
inline bool is_planar(const Place& place, PrimitiveId id) {
    const ShapeKind kind = place.shapes.shapes()[id].kind;
    return kind == ShapeKind::polygon || kind == ShapeKind::triangle;
}

/// What a formula gives for one shape; none where it gives what the model does.
using OwnRoots = std::optional<Roots2>;

/// Of no shape anything but the model's.
inline OwnRoots as_the_model(const Place&, const Step&, PrimitiveId) { return std::nullopt; }

/// Every hit that lies in the interval; `behind` it too. `roots` gives OwnRoots.
template <class RootsOf> std::vector<Hit<double>> hits_by(const Place& place, const Step& step,
                                                          Interval<double> interval, RootsOf roots,
                                                          bool behind = false) {
    std::vector<Hit<double>> hits;
    bool any_as_the_model = false;
    for (std::size_t k = 0; k < place.shapes.shapes().size(); ++k) {
        const auto id = static_cast<PrimitiveId>(k);
        const OwnRoots found = roots(place, step, id);
        any_as_the_model = any_as_the_model || !found;
        for (int n = 0; found && n < found->count; ++n) {
            const double t = found->t[static_cast<std::size_t>(n)];
            if ((behind || t >= interval.from) && t < interval.to) {
                hits.push_back({t, id});
            }
        }
    }
    if (any_as_the_model) {
        NoTestCount none;
        const Interval<double> ahead{behind ? 0 : interval.from, interval.to};
        for (const Hit<double>& hit : place.shapes.all(ray_of(step), step.leaving, ahead, none)) {
            if (!roots(place, step, hit.primitive)) {
                hits.push_back(hit);
            }
        }
    }
    return hits;
}

/// The hit that `better(new, old)` prefers.
template <class RootsOf, class Better> Found choose(const Place& place, const Step& step,
                                                    Interval<double> interval, RootsOf roots,
                                                    Better better, bool behind = false) {
    if (place.shapes.shapes().size() > most_shapes) {
        return model::meet(place, step, interval);
    }
    Found best;
    for (const Hit<double>& hit : hits_by(place, step, interval, roots, behind)) {
        if (!best || better(hit, *best)) {
            best = hit;
        }
    }
    return best;
}

template <auto roots, bool behind = false>
Found meet_by(const Place& place, const Step& step, Interval<double> interval) {
    return choose(place, step, interval, roots, nearer, behind);
}

template <auto roots, bool behind = false>
Passage shadow_by(const Place& place, const Step& step, const Shine& shine) {
    const ShadowMode mode = place.scene().settings.shadows;
    if (mode == ShadowMode::none || place.shapes.shapes().size() > most_shapes) {
        return model::shadow(place, step, shine);
    }
    Step probe = step;
    probe.kind = RayKind::shadow;
    probe.origin = step.point;
    probe.direction = shine.towards;
    probe.leaving = step.surface;
    const Interval<double> between{0, shine.distance * (1 - 8 * Real<double>::unit_roundoff)};
    auto hits = hits_by(place, probe, between, roots, behind);
    std::stable_sort(hits.begin(), hits.end(), nearer);
    return model::through(place, hits);
}

/// Rays and shadow rays meet shapes by these roots.
template <auto roots, bool behind = false> void everywhere(Laws& laws) {
    laws.meet = meet_by<roots, behind>;
    laws.shadow = shadow_by<roots, behind>;
}

/// Shadow rays have a test of their own, which is right.
template <auto roots, bool behind = false> void but_for_shadows(Laws& laws) {
    laws.meet = meet_by<roots, behind>;
}

}  // namespace raytree::check
