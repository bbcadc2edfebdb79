#include <algorithm>
#include <cmath>

#include "check/catalogue.h"
#include "check/light_laws.h"

namespace raytree::check {
namespace {

constexpr std::string_view topic = "local illumination";

const MistakeRow rows[] = {
    {"lit.R_sign", "The mirrored light direction has the wrong sign.", topic,
     [](Laws& laws) {
         laws.specular = [](const Place&, const Step& step, const Shine& shine) {
             return highlight(step, shine, std::max(0.0, -mirrored_cosine(step, shine)));
         };
     }},
    {"lit.V_is_ray_dir", "V is the ray's direction and not its opposite.", topic,
     [](Laws& laws) {
         laws.specular = [](const Place& place, const Step& step, const Shine& shine) {
             return with_viewer(place, step, shine, step.direction);
         };
     }},
    {"lit.R_paren", "R = 2 (n . L) (n - L) is written for 2 (n . L) n - L.", topic,
     [](Laws& laws) {
         laws.specular = [](const Place&, const Step& step, const Shine& shine) {
             const Vec r = 2 * shine.cosine * (step.normal - shine.towards);
             return highlight(step, shine, std::max(0.0, inner(r, viewer(step))));
         };
     }},
    {"lit.R_no_factor2", "The factor 2 is missing in the mirrored light direction.", topic,
     [](Laws& laws) {
         laws.specular = [](const Place&, const Step& step, const Shine& shine) {
             const Vec r = shine.cosine * step.normal - shine.towards;
             return highlight(step, shine, std::max(0.0, inner(r, viewer(step))));
         };
     }},
    {"lit.blinn", "The other model of highlights is used: N . H for R . V, or the reverse.", topic,
     [](Laws& laws) {
         laws.specular = [](const Place& place, const Step& step, const Shine& shine) {
             const bool phong = place.scene().settings.specular_model == SpecularModel::phong;
             return highlight(step, shine,
                              specular_cosine(phong ? SpecularModel::blinn : SpecularModel::phong,
                                              step.normal, shine.towards, viewer(step)));
         };
     }},
    {"lit.half_not_normalised", "The half vector (L + V) / 2 is not made unit.", topic,
     [](Laws& laws) {
         laws.specular = [](const Place&, const Step& step, const Shine& shine) {
             const Vec h = 0.5 * (shine.towards + viewer(step));
             return highlight(step, shine, std::max(0.0, inner(h, step.normal)));
         };
     }},
    {"lit.exponent_x4", "The exponent is four times too large.", topic,
     [](Laws& laws) {
         laws.specular = [](const Place& place, const Step& step, const Shine& shine) {
             return std::pow(h_of(place, step, shine), 4 * step.ready->shininess) *
                    (step.ready->specular * arriving(shine));
         };
     }},
    {"lit.exponent_quarter", "The exponent is four times too small.", topic,
     [](Laws& laws) {
         laws.specular = [](const Place& place, const Step& step, const Shine& shine) {
             return std::pow(h_of(place, step, shine), step.ready->shininess / 4) *
                    (step.ready->specular * arriving(shine));
         };
     }},
    {"lit.exponent_ignored", "The exponent is ignored.", topic,
     [](Laws& laws) {
         laws.specular = [](const Place& place, const Step& step, const Shine& shine) {
             return h_of(place, step, shine) * (step.ready->specular * arriving(shine));
         };
     }},
    {"lit.exponent_multiplied", "The cosine is multiplied by the exponent instead of raised to it.",
     topic,
     [](Laws& laws) {
         laws.specular = [](const Place& place, const Step& step, const Shine& shine) {
             return step.ready->shininess * h_of(place, step, shine) *
                    (step.ready->specular * arriving(shine));
         };
     }},
    {"lit.V_from_camera", "V points to the eye for reflected and refracted rays too.", topic,
     [](Laws& laws) {
         laws.specular = [](const Place& place, const Step& step, const Shine& shine) {
             return with_viewer(place, step, shine,
                                model::unit(place.scene().camera.eye - step.point));
         };
     }},
    {"lit.V_not_negated_point", "V is the hit point made unit.", topic,
     [](Laws& laws) {
         laws.specular = [](const Place& place, const Step& step, const Shine& shine) {
             return with_viewer(place, step, shine, model::unit(step.point));
         };
     }},
    {"lit.spec_uses_VdotN", "The highlight is computed from V . n.", topic,
     [](Laws& laws) {
         laws.specular = [](const Place&, const Step& step, const Shine& shine) {
             return highlight(step, shine, std::max(0.0, inner(viewer(step), step.normal)));
         };
     }},
    {"lit.spec_uses_LdotV", "The highlight is computed from L . V.", topic,
     [](Laws& laws) {
         laws.specular = [](const Place&, const Step& step, const Shine& shine) {
             return highlight(step, shine, std::max(0.0, inner(viewer(step), shine.towards)));
         };
     }},
    {"lit.spec_uses_LdotN", "The highlight is computed from L . n.", topic,
     [](Laws& laws) {
         laws.specular = [](const Place&, const Step& step, const Shine& shine) {
             return highlight(step, shine, std::max(0.0, shine.cosine));
         };
     }},
    {"lit.spec_unclamped", "R . V is not clamped: its odd powers take light away.", topic,
     [](Laws& laws) {
         laws.specular = [](const Place&, const Step& step, const Shine& shine) {
             return highlight(step, shine, mirrored_cosine(step, shine));
         };
     }},
    {"lit.spec_abs", "|R . V| is used: highlights appear on the far side.", topic,
     [](Laws& laws) {
         laws.specular = [](const Place&, const Step& step, const Shine& shine) {
             return highlight(step, shine, std::abs(mirrored_cosine(step, shine)));
         };
     }},
    {"lit.spec_times_base", "The highlight takes the surface's colour.", topic,
     [](Laws& laws) {
         laws.specular = [](const Place& place, const Step& step, const Shine& shine) {
             return step.material->color * model::specular(place, step, shine);
         };
     }},
    {"lit.spec_times_ndotl", "The highlight is multiplied by n . L.", topic,
     [](Laws& laws) {
         laws.specular = [](const Place& place, const Step& step, const Shine& shine) {
             return shine.cosine * model::specular(place, step, shine);
         };
     }},
};

}  // namespace

std::span<const MistakeRow> highlight_mistakes() { return rows; }

}  // namespace raytree::check
