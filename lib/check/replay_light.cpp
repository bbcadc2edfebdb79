#include <algorithm>

#include "check/replay_parts.h"

namespace raytree::check {
/// Diffuse and specular light of all lights.
Replay::Taint Replay::lights(At at, const Step& step, Terms& terms, Taint taint) {
    Taint all = taint;
    for (std::size_t k = 0; k < place_.lights.size(); ++k) {
        all = first_of(all, light(at, step, k, terms, taint));
    }
    Taint diffuse = all, specular = all;
    const double largest =
        std::max(largest_component(terms.diffuse), largest_component(terms.specular));
    const double scale = std::max(darkest_, largest);
    see(at, Field::diffuse, terms.diffuse, scale, diffuse);
    see(at, Field::specular, terms.specular, scale, specular);
    const bool both =
        submission_.gives(at.ray, Field::diffuse) && submission_.gives(at.ray, Field::specular);
    return both ? first_of(diffuse, specular) : first_of(all, first_of(diffuse, specular));
}

Replay::Taint Replay::light(At at, const Step& step, std::size_t light, Terms& terms, Taint taint) {
    Shine shine = shine_of(place_, laws_, step, light);
    const bool sent = laws_.faces(step, shine) && step.ready->lit;
    const std::size_t ray = shadow_child(at.ray, light);
    const std::uint64_t key = key_of_light(at.ray, light);
    note(key, sent ? 1 : 0);
    const bool near_tie = light < most_lights_told_apart && may_be(key, sent ? 0 : 1);
    if (!sent) {
        // A shadow ray for a light that cannot shine here is only idle.
        const bool idle = ray == none || (is_zero(submission_.tree.rays[ray].diffuse) &&
                                          is_zero(submission_.tree.rays[ray].specular));
        if (idle || near_tie) {
            return clean;
        }
        Finding finding;
        start_finding(finding, ray);
        finding.problem = Problem::extra;
        finding.reason = step.ready->lit ? "light_behind_surface" : "surface_unlit";
        terms.diffuse += submission_.tree.rays[ray].diffuse;
        terms.specular += submission_.tree.rays[ray].specular;
        return report(std::move(finding));
    }
    ++rays_;
    Taint own = taint;
    const bool wanted = place_.scene().settings.shadows != ShadowMode::none;
    if (ray != none) {
        own = shadow_ray(
            {ray, true_child(at.truth, RayKind::shadow, place_.scene().lights[light].name)}, at.ray,
            step, shine, taint);
    } else {
        const Passage passage = passage_to(at.ray, step, shine);
        shine.transmittance = passage.transmittance;
        if (submission_.has_shadow_rays && wanted && !near_tie) {
            Finding finding;
            start_finding(finding, at.ray);
            finding.problem = Problem::missing;
            finding.kind = RayKind::shadow;
            finding.light = place_.scene().lights[light].name;
            own = report(std::move(finding));
        }
    }
    Spectrum diffuse = laws_.diffuse(place_, step, shine);
    Spectrum specular = laws_.specular(place_, step, shine);
    if (ray != none) {
        const At there{ray,
                       true_child(at.truth, RayKind::shadow, place_.scene().lights[light].name)};
        const double scale =
            std::max(darkest_, std::max(largest_component(diffuse), largest_component(specular)));
        Taint second = own;
        see(there, Field::diffuse, diffuse, scale, own);
        see(there, Field::specular, specular, scale, second);
        own = first_of(own, second);
    }
    terms.diffuse += diffuse;
    terms.specular += specular;
    return own;
}

/// What of the light arrives at the hit of the ray `from`.
Passage Replay::passage_to(std::size_t from, const Step& step, const Shine& shine) const {
    return options_.met_before ? options_.met_before->shadow(place_, laws_, step, shine, from)
                               : laws_.shadow(place_, step, shine);
}

/// Whether the ray goes from this origin to the light, where it starts a little off the surface.
bool Replay::aims_from(At at, const Vec& origin, const Shine& shine) {
    if (shine.ready->directional) {
        return false;
    }
    const Vec way = shine.ready->position - origin;
    const TreeRay<double>& ray = submission_.tree.rays[at.ray];
    const double allowed = options_.rtol + 8 * submission_.precision.relative;
    const bool aims = !submission_.gives(at.ray, Field::direction) ||
                      length(ray.direction - model::unit(way)) <= allowed;
    const bool reaches =
        !ray.shadow->distance || abs(*ray.shadow->distance - length(way)) <= allowed * length(way);
    return aims && reaches;
}

/// Whether what the submission names stands between the hit and the light: which of several
/// blockers stops the light is of no consequence.
bool Replay::is_in_between(const Blocker<double>& given, const Step& step,
                           const Shine& shine) const {
    NoTestCount uncounted;
    const Ray<double> ray{step.point, shine.towards, model::origin_error(step.point)};
    const double off = largest_offset * std::max(1.0, reach(step));
    const auto hits = place_.shapes.all(ray, step.surface, {0, shine.distance}, uncounted);
    return std::ranges::any_of(hits, [&](const Hit<double>& hit) {
        const bool named = given.object.empty() || names_.means(given.object, hit.primitive);
        return named && (given.t == 0 || abs(hit.t - given.t) <= off);  // 0: not given
    });
}

void Replay::see_blocker(At at, const Step& step, Shine& shine, const Passage& passage,
                         Taint& taint) {
    const auto code = [](PrimitiveId id) {
        return id == no_primitive ? std::int64_t{-1} : static_cast<std::int64_t>(id);
    };
    const auto& given = submission_.tree.rays[at.ray].shadow->blocked_by;
    if (given && meets_start(step, RayKind::shadow, given->object, given->t)) {
        count(at.ray, Field::blocked_by);
        shine.transmittance = Spectrum(0.0);
        return;
    }
    const bool blocked = passage.blocker != no_primitive;
    const bool agreed = given && blocked && names_.means(given->object, passage.blocker) &&
                        abs(given->t - passage.t) <= largest_offset * std::max(1.0, reach(step));
    const auto found = given ? names_.find(given->object) : std::nullopt;
    const bool tie =
        may_be(key_of(at.ray, Field::blocked_by), found ? code(*found) : std::int64_t{-1});
    if (agreed || tie || (!given && !blocked) ||
        (given && blocked && is_in_between(*given, step, shine))) {
        count(at.ray, Field::blocked_by);
    } else {
        decide(at, Field::blocked_by,
               {code(passage.blocker), blocked ? names_.of(passage.blocker) : ""},
               {given ? -3 : -1, given ? std::string_view(given->object) : ""}, taint);
    }
    if (given.has_value() != blocked) {
        shine.transmittance = Spectrum(given ? 0.0 : 1.0);
    }
}

/// The ray towards the light as the submission has it.
Replay::Taint Replay::shadow_ray(At at, std::size_t from, const Step& step, Shine& shine,
                                 Taint taint) {
    Vec origin = laws_.start(place_, step, RayKind::shadow);
    const bool offset = set_off(at, step, RayKind::shadow, shine.towards, origin);
    if (!offset) {
        see(at, Field::origin, origin, reach(step), taint);
    }
    if (!offset || !aims_from(at, origin, shine)) {
        const Vec due = laws_.sent(place_, step, shine);
        Vec sent = due;
        see(at, Field::direction, sent, 1, taint);
        shine.towards = length(due - shine.towards) == 0 ? sent : shine.towards;
        if (shine.distance < Real<double>::infinity) {
            see(at, Field::distance, shine.distance, largest_component(step.point) + shine.distance,
                taint);
        }
    }
    const Passage passage = passage_to(from, step, shine);
    const auto code = [](PrimitiveId id) {
        return id == no_primitive ? std::int64_t{-1} : static_cast<std::int64_t>(id);
    };
    note(key_of(at.ray, Field::blocked_by), code(passage.blocker));
    shine.transmittance = passage.transmittance;
    if (submission_.gives(at.ray, Field::blocked_by)) {
        see_blocker(at, step, shine, passage, taint);
    }
    if (submission_.gives(at.ray, Field::transmittance)) {
        see(at, Field::transmittance, shine.transmittance, 1, taint);
    }
    return taint;
}

}  // namespace raytree::check
