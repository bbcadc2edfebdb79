#include <algorithm>

#include "check/branch_laws.h"
#include "check/convention_tables.h"

namespace raytree::check {
namespace {

void total_reflection_not_looked_at(Laws& laws) {
    laws.why_not = through_total;
    laws.refracted = grazing_where_total;
}

template <bool kt_too>
Spectrum local_takes_the_rest(const Place& place, const Step& step, const Terms& terms) {
    const Spectrum none(0.0);
    const Spectrum& kt = kt_too ? step.kt : none;
    const Spectrum rest(1 - step.kr.r - kt.r, 1 - step.kr.g - kt.g, 1 - step.kr.b - kt.b);
    Terms less = terms;
    for (Spectrum* term : {&less.ambient, &less.diffuse, &less.specular}) {
        *term *= rest;
    }
    return model::combine(place, step, less);
}

Spectrum tinted_by_specular_colour(const Place& place, const Step& step, const Terms& terms) {
    Terms tinted = terms;
    for (Terms::Branch* branch : {&tinted.reflected, &tinted.refracted}) {
        branch->intensity *= step.material->specular_color;
    }
    return model::combine(place, step, tinted);
}

Spectrum at_most_one(const Spectrum& c) {
    return {std::min(1.0, c.r), std::min(1.0, c.g), std::min(1.0, c.b)};
}

Spectrum surface_clamped(const Place& place, const Step& step, const Terms& terms) {
    Terms clamped = terms;
    clamped.ambient = at_most_one(terms.ambient + terms.diffuse + terms.specular);
    clamped.diffuse = clamped.specular = Spectrum(0.0);
    return model::combine(place, step, clamped);
}

Spectrum every_level_clamped(const Place& place, const Step& step, const Terms& terms) {
    return at_most_one(model::combine(place, step, terms));
}

Indices same_on_leaving(const Place& place, const Step& step) {
    const Indices at = model::indices(place, step);
    return step.front ? at : Indices{at.eta2, at.eta1};
}

}  // namespace

const std::vector<Convention>& tree_conventions() {
    static const std::vector<Convention> table = {
        {"combine", "add", "reflected and refracted light is added to local light", nullptr,
         nullptr, ""},
        {"combine", "lerp", "reflection replaces local light: (1 - kr) local + kr reflected",
         nullptr, [](Laws& laws) { laws.combine = local_takes_the_rest<false>; }, "rec.lerp"},
        {"combine", "complement", "local light has what is left, 1 - kr - kt", nullptr,
         [](Laws& laws) { laws.combine = local_takes_the_rest<true>; }, "rec.lerp"},
        {"combine", "specular-colour", "reflected and refracted light takes the specular colour",
         nullptr, [](Laws& laws) { laws.combine = tinted_by_specular_colour; }, ""},
        {"clamp", "end", "colours are clamped at the end", nullptr, nullptr, ""},
        {"clamp", "surface", "local light is clamped to 1 before what is reflected is added",
         nullptr, [](Laws& laws) { laws.combine = surface_clamped; }, "lit.clamped_early"},
        {"clamp", "levels", "colours are clamped to 1 at every level", nullptr,
         [](Laws& laws) { laws.combine = every_level_clamped; }, "out.child_clamped"},
        {"eta-exit", "inverted", "the ratio of the indices is inverted on leaving", nullptr,
         nullptr, ""},
        {"eta-exit", "same", "the ratio of the indices is not inverted on leaving", nullptr,
         [](Laws& laws) { laws.indices = same_on_leaving; }, "refr.eta_same_on_exit"},
        {"tir", "scene", "total reflection as the scene says", nullptr, nullptr, ""},
        {"tir", "drop", "total reflection adds nothing to the reflected ray",
         [](Scene& scene) { scene.settings.total_internal_reflection = TotalReflection::drop; },
         nullptr, "refr.tir_black"},
        {"tir", "reflect", "total reflection adds kt to kr",
         [](Scene& scene) { scene.settings.total_internal_reflection = TotalReflection::reflect; },
         nullptr, "refr.tir_full"},
        {"tir", "none", "total reflection is not looked at: the refracted ray grazes the surface",
         nullptr, total_reflection_not_looked_at, "refr.tir_zero"},
        {"miss", "scene", "secondary rays that hit nothing have the colour that the scene says",
         nullptr, nullptr, ""},
        {"miss", "background", "secondary rays that hit nothing have the background's colour",
         [](Scene& scene) { scene.settings.secondary_background = scene.background; }, nullptr,
         "bg.background_for_secondary"},
        {"miss", "black", "secondary rays that hit nothing are black",
         [](Scene& scene) { scene.settings.secondary_background = Colour(0.0); }, nullptr,
         "bg.black_for_secondary"},
        {"miss", "ambient", "secondary rays that hit nothing see the background in ambient light",
         [](Scene& scene) {
             scene.settings.secondary_background =
                 scene.ambient * scene.settings.secondary_background.value_or(scene.background);
         },
         nullptr, "bg.secondary_ambient"},
        {"depth", "from-1", "the primary ray is at level 1", nullptr, nullptr, ""},
        {"depth", "from-0", "the primary ray is at level 0: one level more",
         [](Scene& scene) { ++scene.settings.max_depth; }, nullptr, "rec.depth_plus_one"},
        {"cut-off", "weight", "branches of small weight are cut off as the scene says", nullptr,
         nullptr, ""},
        {"cut-off", "none", "only the depth cuts branches off",
         [](Scene& scene) { scene.settings.min_weight = 0; }, nullptr, "rec.min_weight_ignored"},
        {"quantise", "scene", "colours are rounded to 8 bits as the scene says", nullptr, nullptr,
         ""},
        {"quantise", "floor", "255 times the colour, cut off",
         [](Scene& scene) { scene.settings.quantize = Quantize::floor; }, nullptr, ""},
        {"quantise", "round", "255 times the colour, rounded",
         [](Scene& scene) { scene.settings.quantize = Quantize::round; }, nullptr, ""},
        // Never more than a level from the others, which is what pictures may be off.
        {"quantise", "floor-255.9", "255.9 times the colour, cut off", nullptr, nullptr, ""},
        {"quantise", "floor-255.999", "255.999 times the colour, cut off", nullptr, nullptr, ""},
        // Of pictures alone, and only where a profile with it is asked for.
        {"gamma", "none", "colours are written as they are", nullptr, nullptr, ""},
        {"gamma", "2.2", "a gamma curve of 2.2 is applied to the finished picture", nullptr,
         nullptr, "out.gamma"},
        {"gamma", "2", "the square root of each colour is taken for the finished picture", nullptr,
         nullptr, "out.gamma_2"},
    };
    return table;
}

}  // namespace raytree::check
