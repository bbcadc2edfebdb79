#include "check/conventions.h"

#include <algorithm>
#include <cmath>

#include "formats/did_you_mean.h"
#include "scene/input_error.h"
#include "trace/shading.h"

namespace raytree::check {
namespace {

/// The window that the camera has, whichever way it is given.
ImagePlane& window_of(Scene& scene) {
    Camera& camera = scene.camera;
    if (const auto* fov = std::get_if<HorizontalFov>(&camera.window)) {
        const double x = std::tan(fov->degrees * Real<double>::pi / 360);
        const double y = x * camera.height / camera.width;
        camera.window = ImagePlane{-x, x, -y, y};
    }
    return std::get<ImagePlane>(camera.window);
}

void sample_lower_left(Scene& scene) {
    ImagePlane& window = window_of(scene);
    const double row = (window.top - window.bottom) / scene.camera.height;
    window.top -= row;
    window.bottom -= row;
    scene.settings.pixel_sample = PixelSample::corner;
}

/// The first and the last pixel on the window's edges: it is as much wider as a pixel more.
void sample_edges(Scene& scene) {
    ImagePlane& window = window_of(scene);
    const auto stretched = [](double from, double to, int pixels) {
        return pixels > 1 ? from + (to - from) * pixels / (pixels - 1) : to;
    };
    window.right = stretched(window.left, window.right, scene.camera.width);
    window.bottom = stretched(window.top, window.bottom, scene.camera.height);
    scene.settings.pixel_sample = PixelSample::corner;
}

void rows_from_below(Scene& scene) {
    ImagePlane& window = window_of(scene);
    std::swap(window.top, window.bottom);
}

void vertical_fov(Scene& scene) {
    const double aspect = static_cast<double>(scene.camera.width) / scene.camera.height;
    ImagePlane& window = window_of(scene);
    for (double* edge : {&window.left, &window.right, &window.bottom, &window.top}) {
        *edge *= aspect;
    }
}

void fade_all(Scene& scene, const Attenuation& fading) {
    for (Light& light : scene.lights) {
        if (auto* point = std::get_if<PointLight>(&light.kind)) {
            point->attenuation = fading;
        }
    }
}

Interval<double> near_for_all(const Place& place, const Step& step) {
    Interval<double> interval = model::interval(place, step);
    interval.from = std::max(interval.from, place.scene().camera.near);
    return interval;
}

Spectrum highlight_seen_from_the_eye(const Place& place, const Step& step, const Shine& shine) {
    Step seen = step;
    seen.direction = model::unit(step.point - place.scene().camera.eye);
    return model::specular(place, seen, shine);
}

bool any_light(const Step&, const Shine&) { return true; }

Spectrum only_in_front(const Place& place, const Step& step, const Shine& shine) {
    return shine.cosine > 0 ? model::diffuse(place, step, shine) : Spectrum(0.0);
}

Spectrum ambient_without_colour(const Place& place, const Step& step) {
    return step.material->ka * place.scene().ambient;
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

Turned outward(const Place&, const Step& step) {
    return {step.shading, inner(step.direction, step.outward) < 0};
}

const std::vector<Convention>& camera_conventions() {
    static const std::vector<Convention> table = {
        {"sample", "scene", "rays go through the pixel where the scene says", nullptr, nullptr, ""},
        {"sample", "centre", "rays go through the middle of the pixel",
         [](Scene& scene) { scene.settings.pixel_sample = PixelSample::center; }, nullptr,
         "cam.half_added_twice"},
        {"sample", "corner", "rays go through the upper left corner of the pixel",
         [](Scene& scene) { scene.settings.pixel_sample = PixelSample::corner; }, nullptr,
         "cam.no_half"},
        {"sample", "corner-bl", "rays go through the lower left corner of the pixel",
         sample_lower_left, nullptr, "cam.no_half"},
        {"sample", "edges", "the first and the last pixel lie on the window's edges", sample_edges,
         nullptr, "cam.wminus1"},
        {"rows", "down", "rows are counted from above", nullptr, nullptr, ""},
        {"rows", "up", "rows are counted from below", rows_from_below, nullptr, "cam.y_flipped"},
        {"fov", "horizontal", "the angle of view is the horizontal one", nullptr, nullptr, ""},
        {"fov", "vertical", "the angle of view is the vertical one", vertical_fov, nullptr,
         "cam.fov_horizontal"},
        {"near", "primary", "primary rays do not see what is nearer than the near distance",
         nullptr, nullptr, ""},
        {"near", "all", "no ray sees what is nearer than the near distance", nullptr,
         [](Laws& laws) { laws.interval = near_for_all; }, "hit.near_rule_on_secondary"},
        {"near", "none", "the near distance has no effect",
         [](Scene& scene) { scene.camera.near = 0; }, nullptr, "hit.primary_without_near"},
    };
    return table;
}

const std::vector<Convention>& light_conventions() {
    static const std::vector<Convention> table = {
        {"specular", "scene", "highlights as the scene says", nullptr, nullptr, ""},
        {"specular", "phong", "highlights by the mirrored light, R . V",
         [](Scene& scene) { scene.settings.specular_model = SpecularModel::phong; }, nullptr,
         "lit.blinn"},
        {"specular", "blinn", "highlights by the half vector, N . H",
         [](Scene& scene) { scene.settings.specular_model = SpecularModel::blinn; }, nullptr,
         "lit.blinn"},
        {"gate", "facing", "no highlight where the light is behind the surface", nullptr, nullptr,
         ""},
        {"gate", "none", "highlights also where the light is behind the surface", nullptr,
         [](Laws& laws) {
             laws.faces = any_light;
             laws.diffuse = only_in_front;
         },
         "lit.spec_on_backface"},
        {"viewer", "ray", "highlights are seen along the ray", nullptr, nullptr, ""},
        {"viewer", "eye", "highlights are seen from the eye, in mirrors too", nullptr,
         [](Laws& laws) { laws.specular = highlight_seen_from_the_eye; }, "lit.V_from_camera"},
        {"attenuation", "scene", "lights fade as the scene says", nullptr, nullptr, ""},
        {"attenuation", "none", "lights do not fade",
         [](Scene& scene) {
             fade_all(scene, {1, 0, 0});
         },
         nullptr, "lit.att_missing"},
        {"attenuation", "inverse-square", "lights fade with the square of the distance",
         [](Scene& scene) {
             fade_all(scene, {0, 0, 1});
         },
         nullptr, "lit.att_inverse_square"},
        {"ambient", "once", "ambient light is added once, in the surface's colour", nullptr,
         nullptr, ""},
        {"ambient", "per-light", "ambient light is added for each light",
         [](Scene& scene) {
             scene.ambient = static_cast<double>(scene.lights.size()) * scene.ambient;
         },
         nullptr, "lit.ambient_per_light"},
        {"ambient", "uncoloured", "ambient light does not take the surface's colour", nullptr,
         [](Laws& laws) { laws.ambient = ambient_without_colour; }, "lit.ambient_no_color"},
        {"inside-normal", "turned", "normals are turned to the ray", nullptr, nullptr, ""},
        {"inside-normal", "outward", "normals point outwards on the inside too", nullptr,
         [](Laws& laws) { laws.normal = outward; }, "nrm.not_flipped_inside"},
    };
    return table;
}

const std::vector<Convention>& tree_conventions() {
    static const std::vector<Convention> table = {
        {"combine", "add", "reflected and refracted light is added to local light", nullptr,
         nullptr, ""},
        {"combine", "lerp", "reflection replaces local light: (1 - kr) local + kr reflected",
         nullptr, [](Laws& laws) { laws.combine = local_takes_the_rest<false>; }, "rec.lerp"},
        {"combine", "complement", "local light has what is left, 1 - kr - kt", nullptr,
         [](Laws& laws) { laws.combine = local_takes_the_rest<true>; }, "rec.lerp_both"},
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
        {"quantise", "scene", "colours are rounded to 8 bits as the scene says", nullptr, nullptr,
         ""},
        {"quantise", "floor", "255 times the colour, cut off",
         [](Scene& scene) { scene.settings.quantize = Quantize::floor; }, nullptr, ""},
        {"quantise", "round", "255 times the colour, rounded",
         [](Scene& scene) { scene.settings.quantize = Quantize::round; }, nullptr, ""},
    };
    return table;
}

}  // namespace

const std::vector<Convention>& conventions() {
    static const std::vector<Convention> table = [] {
        std::vector<Convention> all;
        for (const auto* part :
             {&camera_conventions(), &light_conventions(), &tree_conventions()}) {
            all.insert(all.end(), part->begin(), part->end());
        }
        return all;
    }();
    return table;
}

Choices default_choices() {
    Choices choices;
    for (const Convention& convention : conventions()) {
        if (choices.empty() || choices.back()->axis != convention.axis) {
            choices.push_back(&convention);
        }
    }
    return choices;
}

Choices with_choice(Choices choices, std::string_view choice) {
    const auto equals = choice.find('=');
    for (const Convention& convention : conventions()) {
        if (convention.axis == choice.substr(0, equals) &&
            convention.value == choice.substr(equals + 1)) {
            std::ranges::find(choices, convention.axis, &Convention::axis)[0] = &convention;
        }
    }
    return choices;
}

std::string text_of(const Choices& choices) {
    std::string text;
    for (const Convention* choice : choices) {
        if (choice->on_scene || choice->on_laws) {
            text += (text.empty() ? "" : " ") + std::string(choice->axis) + '=' +
                    std::string(choice->value);
        }
    }
    return text;
}

const std::vector<Profile>& profiles() {
    static const std::vector<Profile> table = {
        {"lecture", "the model as it is, with the scene's settings", {}},
        {"corner", "the lecture with rays through pixel corners", {"sample=corner"}},
        {"ucla",
         "rays through the upper left corners of pixels; secondary rays that miss are black",
         {"sample=corner", "near=primary", "miss=black", "quantise=floor"}},
        {"ucla-2015",
         "as ucla, and the near plane cuts reflections too",
         {"sample=corner", "near=all", "miss=black", "quantise=floor"}},
        {"ucla-bl",
         "as ucla, with the lower left corner",
         {"sample=corner-bl", "near=primary", "miss=black", "quantise=floor"}},
        {"ucla-js",
         "one ratio of indices on entering and leaving; local light is clamped; secondary rays "
         "that miss are black",
         {"near=none", "clamp=surface", "eta-exit=same", "miss=black", "quantise=floor"}},
        {"ucr",
         "half vectors; reflection takes its share from the local light",
         {"specular=blinn", "combine=lerp"}},
        {"uvic",
         "rays through pixel corners; normals stay outward inside; secondary rays that miss are "
         "black",
         {"sample=corner", "near=primary", "inside-normal=outward", "miss=black",
          "quantise=floor"}},
        {"weekend",
         "a vertical angle of view; the first and the last pixel lie on the window's edges",
         {"sample=edges", "fov=vertical", "quantise=floor"}},
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

}  // namespace raytree::check
