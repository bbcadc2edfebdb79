#include "check/conventions.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "check/film.h"
#include "check/replay.h"
#include "formats/did_you_mean.h"
#include "scene/input_error.h"
#include "trace/shading.h"

namespace raytree::check {
namespace {

Beam through_window(const Place& place, double u, double v) {
    return beam_through(place, film_at(place, u, v));
}

template <int half_columns, int half_rows> Beam sampled_at(const Place& place, const Step& step) {
    const Camera& camera = place.scene().camera;
    return through_window(place, (step.pixel_i + 0.5 * half_columns) / camera.width,
                          (step.pixel_j + 0.5 * half_rows) / camera.height);
}

Beam spread_to_the_edges(const Place& place, const Step& step) {
    const Camera& camera = place.scene().camera;
    return through_window(place, step.pixel_i / std::max(1.0, camera.width - 1.0),
                          step.pixel_j / std::max(1.0, camera.height - 1.0));
}

Beam rows_from_below(const Place& place, const Step& step) {
    Step turned = step;
    turned.pixel_j = place.scene().camera.height - 1 - step.pixel_j;
    return model::primary(place, turned);
}

Beam vertical_fov(const Place& place, const Step& step) {
    const Beam beam = model::primary(place, step);
    const Vec forward = place.camera.forward().vec();
    const double aspect =
        static_cast<double>(place.scene().camera.width) / place.scene().camera.height;
    const Vec film = beam.direction / inner(beam.direction, forward);
    return {beam.origin, forward + aspect * (film - forward)};
}

Interval<double> near_for_all(const Place& place, const Step& step) {
    Interval<double> interval = model::interval(place, step);
    interval.from = std::max(interval.from, place.scene().camera.near);
    return interval;
}

Interval<double> without_near(const Place& place, const Step& step) {
    Interval<double> interval = model::interval(place, step);
    interval.from = 0;
    return interval;
}

template <SpecularModel which>
Spectrum specular_by(const Place&, const Step& step, const Shine& shine) {
    const double g = shine.ready->directional ? 1 : shine.ready->attenuation.at(shine.distance);
    const double h = specular_cosine(which, step.normal, shine.towards, Vec(-step.direction));
    return std::pow(h, step.ready->shininess) *
           (step.ready->specular * (g * (shine.ready->intensity * shine.transmittance)));
}

Spectrum lerp(const Place&, const Step& step, const Terms& terms) {
    Spectrum local = terms.ambient + terms.diffuse + terms.specular;
    local *= Spectrum(1 - step.kr.r, 1 - step.kr.g, 1 - step.kr.b);
    for (const Terms::Branch& branch : {terms.reflected, terms.refracted}) {
        if (branch.grown) {
            local += branch.attenuation * (branch.coefficient * branch.intensity);
        }
    }
    return local;
}

Spectrum specular_colour(const Place& place, const Step& step, const Terms& terms) {
    Terms tinted = terms;
    for (Terms::Branch* branch : {&tinted.reflected, &tinted.refracted}) {
        branch->intensity *= step.material->specular_color;
    }
    return model::combine(place, step, tinted);
}

Indices same_on_leaving(const Place& place, const Step& step) {
    const Indices at = model::indices(place, step);
    return step.front ? at : Indices{at.eta2, at.eta1};
}

template <bool reflects>
Spectrum total_reflection_by(const Place&, const Step& step, RayKind kind) {
    Spectrum k = kind == RayKind::reflected ? step.ready->kr : step.ready->kt;
    if (reflects && kind == RayKind::reflected && step.total_reflection()) {
        k += step.ready->kt;
    }
    return k;
}

Spectrum black_miss(const Place& place, const Step& step) {
    return step.kind == RayKind::primary ? place.background : Spectrum(0.0);
}
Spectrum background_miss(const Place& place, const Step&) { return place.background; }

Turned outward(const Place&, const Step& step) {
    return {step.shading, inner(step.direction, step.outward) < 0};
}

std::optional<Reason> one_level_more(const Place& place, const Step& step, RayKind kind,
                                     const Spectrum& weight) {
    Step above = step;
    above.level = step.level - 1;
    return model::why_not(place, above, kind, weight);
}

}  // namespace

const std::vector<Convention>& conventions() {
    static const std::vector<Convention> table = {
        {"sample", "centre", "rays go through the middle of the pixel",
         [](Laws& laws) { laws.primary = sampled_at<1, 1>; }},
        {"sample", "corner", "rays go through the upper left corner of the pixel",
         [](Laws& laws) { laws.primary = sampled_at<0, 0>; }},
        {"sample", "corner-bl", "rays go through the lower left corner of the pixel",
         [](Laws& laws) { laws.primary = sampled_at<0, 2>; }},
        {"sample", "edges", "the first and the last pixel lie on the window's edges",
         [](Laws& laws) { laws.primary = spread_to_the_edges; }},
        {"rows", "up", "rows are counted from below",
         [](Laws& laws) { laws.primary = rows_from_below; }},
        {"fov", "vertical", "the angle of view is the vertical one",
         [](Laws& laws) { laws.primary = vertical_fov; }},
        {"near", "all", "no ray sees what is nearer than the near distance",
         [](Laws& laws) { laws.interval = near_for_all; }},
        {"near", "none", "the near distance has no effect",
         [](Laws& laws) { laws.interval = without_near; }},
        {"specular", "phong", "highlights by the mirrored light, R . V",
         [](Laws& laws) { laws.specular = specular_by<SpecularModel::phong>; }},
        {"specular", "blinn", "highlights by the half vector, N . H",
         [](Laws& laws) { laws.specular = specular_by<SpecularModel::blinn>; }},
        {"combine", "lerp", "reflection replaces local light: (1 - kr) local + kr reflected",
         [](Laws& laws) { laws.combine = lerp; }},
        {"combine", "specular-colour", "reflected and refracted light takes the specular colour",
         [](Laws& laws) { laws.combine = specular_colour; }},
        {"eta-exit", "same", "the ratio of the indices is not inverted on leaving",
         [](Laws& laws) { laws.indices = same_on_leaving; }},
        {"tir", "drop", "total reflection adds nothing to the reflected ray",
         [](Laws& laws) { laws.coefficient = total_reflection_by<false>; }},
        {"tir", "reflect", "total reflection adds kt to kr",
         [](Laws& laws) { laws.coefficient = total_reflection_by<true>; }},
        {"miss", "black", "secondary rays that hit nothing are black",
         [](Laws& laws) { laws.miss = black_miss; }},
        {"miss", "background", "secondary rays that hit nothing have the background's colour",
         [](Laws& laws) { laws.miss = background_miss; }},
        {"inside-normal", "outward", "normals point outwards on the inside too",
         [](Laws& laws) { laws.normal = outward; }},
        {"depth", "from-0", "the primary ray is at level 0: one level more",
         [](Laws& laws) { laws.why_not = one_level_more; }},
    };
    return table;
}

const std::vector<Profile>& profiles() {
    static const std::vector<Profile> table = {
        {"lecture", "the model as it is, with the scene's settings", {}},
        {"ucla",
         "corners of pixels; no ray sees what is nearer than the near plane; secondary "
         "rays that miss are black",
         {"sample=corner", "near=all", "miss=black"}},
        {"ucla-bl",
         "as ucla, with the lower left corner",
         {"sample=corner-bl", "near=all", "miss=black"}},
        {"ucla-js",
         "one ratio of indices on entering and leaving; secondary misses are black",
         {"eta-exit=same", "miss=black"}},
        {"ucr",
         "half vectors; reflection takes its share from the local light",
         {"specular=blinn", "combine=lerp"}},
        {"uvic",
         "normals stay outward inside; rays through pixel corners",
         {"sample=corner", "inside-normal=outward"}},
        {"weekend",
         "a vertical angle of view, pixels spread to the window's edges",
         {"fov=vertical"}},
        {"corner", "the lecture with rays through pixel corners", {"sample=corner"}},
    };
    return table;
}

const Profile& profile_named(std::string_view name) {
    std::vector<std::string_view> names;
    for (const Profile& profile : profiles()) {
        if (profile.name == name) {
            return profile;
        }
        names.push_back(profile.name);
    }
    std::string all;
    for (const std::string_view each : names) {
        all += (all.empty() ? "" : ", ") + std::string(each);
    }
    throw InputError("", "",
                     "there is no profile \"" + std::string(name) + '"' +
                         did_you_mean(name, names) + "; there are " + all);
}

Laws laws_of(const Profile& profile) {
    Laws laws = model_laws();
    for (const std::string_view choice : profile.choices) {
        const auto equals = choice.find('=');
        for (const Convention& convention : conventions()) {
            if (convention.axis == choice.substr(0, equals) &&
                convention.value == choice.substr(equals + 1)) {
                convention.apply(laws);
            }
        }
    }
    return laws;
}

const Profile& best_profile(const Place& place, const Names& names, const Submission& submission) {
    const Profile* best = &profiles().front();
    ReplayOptions options;
    options.most_rays = 2000;
    std::size_t fewest = ~std::size_t{0};
    for (const Profile& profile : profiles()) {
        options.enough = fewest;
        const Laws laws = laws_of(profile);
        Replay replay(place, names, laws, submission, options);
        replay.run();
        if (replay.causes() < fewest) {
            best = &profile;
            fewest = replay.causes();
        }
        if (fewest == 0) {
            break;
        }
    }
    return *best;
}

}  // namespace raytree::check
