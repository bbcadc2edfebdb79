#include <cmath>

#include "check/convention_tables.h"
#include "check/light_laws.h"
#include "trace/shading.h"

namespace raytree::check {
namespace {

/// Of m lights each gives a share of 1 / sqrt(m).
void share_by_root(Scene& scene) {
    for (Light& light : scene.lights) {
        light.intensity = 1 / std::sqrt(static_cast<double>(scene.lights.size())) * light.intensity;
    }
}

void fade_all(Scene& scene, const Attenuation& fading) {
    for (Light& light : scene.lights) {
        if (auto* point = std::get_if<PointLight>(&light.kind)) {
            point->attenuation = fading;
        }
    }
}

Spectrum highlight_seen_from_the_eye(const Place& place, const Step& step, const Shine& shine) {
    Step seen = step;
    seen.direction = model::unit(step.point - place.scene().camera.eye);
    return model::specular(place, seen, shine);
}

/// R . V or N . H as it comes, its odd powers with their sign; or without it.
template <bool absolute>
Spectrum highlight_not_clamped(const Place& place, const Step& step, const Shine& shine) {
    const bool phong = place.scene().settings.specular_model == SpecularModel::phong;
    const double h = phong ? mirrored_cosine(step, shine)
                           : inner(step.normal, model::unit(shine.towards + viewer(step)));
    return highlight(step, shine, absolute ? std::abs(h) : h);
}

Spectrum highlight_in_surface_colour(const Place& place, const Step& step, const Shine& shine) {
    return step.material->color * model::specular(place, step, shine);
}

bool any_light(const Step&, const Shine&) { return true; }

Spectrum only_in_front(const Place& place, const Step& step, const Shine& shine) {
    return shine.cosine > 0 ? model::diffuse(place, step, shine) : Spectrum(0.0);
}

Spectrum ambient_without_colour(const Place& place, const Step& step) {
    return step.material->ka * place.scene().ambient;
}

Turned outward(const Place&, const Step& step) {
    return {step.shading, inner(step.direction, step.outward) < 0};
}

}  // namespace

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
        {"sign", "clamped", "the cosine of the highlight is at least 0", nullptr, nullptr, ""},
        {"sign", "signed", "the cosine of the highlight keeps its sign", nullptr,
         [](Laws& laws) { laws.specular = highlight_not_clamped<false>; }, "lit.spec_unclamped"},
        {"sign", "absolute", "the cosine of the highlight loses its sign", nullptr,
         [](Laws& laws) { laws.specular = highlight_not_clamped<true>; }, "lit.spec_abs"},
        {"highlight-colour", "specular", "highlights have the specular colour", nullptr, nullptr,
         ""},
        {"highlight-colour", "surface", "highlights have the surface's colour too", nullptr,
         [](Laws& laws) { laws.specular = highlight_in_surface_colour; }, "lit.spec_times_base"},
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
        {"attenuation", "four-pi", "lights fade with 4 pi times the square of the distance",
         [](Scene& scene) {
             fade_all(scene, {0, 0, 4 * Real<double>::pi});
         },
         nullptr, "lit.att_inverse_square"},
        {"lights", "whole", "each light has the intensity that the scene says", nullptr, nullptr,
         ""},
        {"lights", "root", "each of m lights has 1 / sqrt(m) of its intensity", share_by_root,
         nullptr, "lit.averaged_over_lights"},
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

}  // namespace raytree::check
