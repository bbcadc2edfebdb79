#include <algorithm>
#include <cmath>

#include "check/catalogue.h"
#include "check/light_laws.h"

namespace raytree::check {
namespace {

constexpr std::string_view topic = "local illumination";

bool always(const Step&, const Shine&) { return true; }

Spectrum divided(const Spectrum& a, const Spectrum& b) {
    const auto by = [](double x, double y) { return y != 0 ? x / y : 0; };
    return {by(a.r, b.r), by(a.g, b.g), by(a.b, b.b)};
}

/// Both terms times a factor of the material and the light.
template <class Factor> void scale_by(Laws& laws, Factor) {
    laws.diffuse = [](const Place& place, const Step& step, const Shine& shine) {
        return Factor{}(place, step, shine) * model::diffuse(place, step, shine);
    };
    laws.specular = [](const Place& place, const Step& step, const Shine& shine) {
        return Factor{}(place, step, shine) * model::specular(place, step, shine);
    };
}

Spectrum scene_ambient(const Place& place) { return place.scene().ambient; }

double size_of_l(const Shine& shine) { return shine.ready->directional ? 1 : shine.distance; }

/// n . L with an L that is not unit.
void long_diffuse(Laws& laws) {
    laws.diffuse = [](const Place& place, const Step& step, const Shine& shine) {
        return size_of_l(shine) * model::diffuse(place, step, shine);
    };
}

const MistakeRow rows[] = {
    {"lit.ambient_missing", "Ambient light is missing.", topic,
     [](Laws& laws) { laws.ambient = [](const Place&, const Step&) { return Spectrum(0.0); }; }},
    {"lit.ambient_no_color", "Ambient light does not take the surface's colour.", topic,
     [](Laws& laws) {
         laws.ambient = [](const Place& place, const Step& step) {
             return step.material->ka * scene_ambient(place);
         };
     }},
    {"lit.ambient_no_ka", "Ambient light is not multiplied by ka.", topic,
     [](Laws& laws) {
         laws.ambient = [](const Place& place, const Step& step) {
             return step.material->color * scene_ambient(place);
         };
     }},
    {"lit.ambient_no_scene", "Ambient light is not multiplied by the scene's.", topic,
     [](Laws& laws) {
         laws.ambient = [](const Place&, const Step& step) {
             return step.material->ka * step.material->color;
         };
     }},
    {"lit.ambient_uses_kd", "Ambient light is multiplied by kd instead of ka.", topic,
     [](Laws& laws) {
         laws.ambient = [](const Place& place, const Step& step) {
             return step.material->kd * step.material->color * scene_ambient(place);
         };
     }},
    {"lit.ambient_per_light", "Ambient light is added once for each light.", topic,
     [](Laws& laws) {
         laws.ambient = [](const Place& place, const Step& step) {
             return static_cast<double>(place.lights.size()) * step.ready->ambient;
         };
     }},
    {"lit.L_reversed", "The direction to the light is the wrong way round.", topic,
     [](Laws& laws) {
         laws.towards = [](const Place& place, const Step& step, std::size_t light) {
             Towards at = model::towards(place, step, light);
             at.towards = -at.towards;
             return at;
         };
     }},
    {"lit.L_not_normalised",
     "The direction to the light is not made unit.",
     topic,
     [](Laws& laws) {
         long_diffuse(laws);
         laws.specular = [](const Place& place, const Step& step, const Shine& shine) {
             const Vec l = size_of_l(shine) * shine.towards;
             return highlight(step, shine,
                              specular_cosine(place.scene().settings.specular_model, step.normal, l,
                                              viewer(step)));
         };
     },
     {long_diffuse,
      [](Laws& laws) {
          long_diffuse(laws);
          laws.specular = [](const Place& place, const Step& step, const Shine& shine) {
              return highlight(step, shine, size_of_l(shine) * h_of(place, step, shine));
          };
      }}},
    {"lit.L_is_position", "The light's position is used as the direction to it.", topic,
     [](Laws& laws) {
         laws.towards = [](const Place& place, const Step& step, std::size_t light) {
             Towards at = model::towards(place, step, light);
             if (!place.lights[light].directional) {
                 at.towards = model::unit(place.lights[light].position);
             }
             return at;
         };
     }},
    {"lit.L_from_eye", "The direction to the light is taken from the eye.", topic,
     [](Laws& laws) {
         laws.towards = [](const Place& place, const Step& step, std::size_t light) {
             Step eye = step;
             eye.point = place.scene().camera.eye;
             return model::towards(place, eye, light);
         };
     }},
    {"lit.directional_sign", "A directional light shines from where it goes to.", topic,
     [](Laws& laws) {
         laws.towards = [](const Place& place, const Step& step, std::size_t light) {
             Towards at = model::towards(place, step, light);
             at.towards = place.lights[light].directional ? -at.towards : at.towards;
             return at;
         };
     }},
    {"lit.ndotl_unclamped", "n . L is not clamped: lights behind the surface take light away.",
     topic,
     [](Laws& laws) {
         laws.faces = always;
         laws.specular = [](const Place& place, const Step& step, const Shine& shine) {
             return shine.cosine > 0 ? model::specular(place, step, shine) : Spectrum(0.0);
         };
     }},
    {"lit.ndotl_abs", "|n . L| is used: lights behind the surface light it too.", topic,
     [](Laws& laws) {
         laws.faces = always;
         laws.diffuse = [](const Place& place, const Step& step, const Shine& shine) {
             return (shine.cosine < 0 ? -1.0 : 1.0) * model::diffuse(place, step, shine);
         };
         laws.specular = [](const Place& place, const Step& step, const Shine& shine) {
             return shine.cosine > 0 ? model::specular(place, step, shine) : Spectrum(0.0);
         };
     }},
    {"lit.spec_on_backface", "Highlights appear where the light is behind the surface.", topic,
     [](Laws& laws) {
         laws.faces = always;
         laws.diffuse = [](const Place& place, const Step& step, const Shine& shine) {
             return shine.cosine > 0 ? model::diffuse(place, step, shine) : Spectrum(0.0);
         };
     }},
    {"lit.diffuse_no_cosine", "Diffuse light is not multiplied by n . L.", topic,
     [](Laws& laws) {
         laws.diffuse = [](const Place&, const Step& step, const Shine& shine) {
             return step.ready->diffuse * arriving(shine);
         };
     }},
    {"lit.diffuse_no_color", "Diffuse light does not take the surface's colour.", topic,
     [](Laws& laws) {
         laws.diffuse = [](const Place&, const Step& step, const Shine& shine) {
             return shine.cosine * (step.material->kd * arriving(shine));
         };
     }},
    {"lit.kd_missing", "Diffuse light is not multiplied by kd.", topic,
     [](Laws& laws) {
         laws.diffuse = [](const Place&, const Step& step, const Shine& shine) {
             return shine.cosine * (step.material->color * arriving(shine));
         };
     }},
    {"lit.ks_missing", "The highlight is not multiplied by ks.", topic,
     [](Laws& laws) {
         laws.specular = [](const Place& place, const Step& step, const Shine& shine) {
             return std::pow(h_of(place, step, shine), step.ready->shininess) *
                    (step.material->specular_color * arriving(shine));
         };
     }},
    {"lit.light_color_ignored", "The light's intensity is ignored.", topic,
     [](Laws& laws) {
         scale_by(laws, [](const Place&, const Step&, const Shine& shine) {
             return divided(Spectrum(1.0), shine.ready->intensity);
         });
     }},
    {"lit.spec_no_light_color", "The highlight does not take the light's intensity.", topic,
     [](Laws& laws) {
         laws.specular = [](const Place& place, const Step& step, const Shine& shine) {
             return divided(model::specular(place, step, shine), shine.ready->intensity);
         };
     }},
    {"lit.ks_kd_swapped", "kd and ks are exchanged.", topic,
     [](Laws& laws) {
         laws.diffuse = [](const Place&, const Step& step, const Shine& shine) {
             return shine.cosine * (step.material->ks * (step.material->color * arriving(shine)));
         };
         laws.specular = [](const Place& place, const Step& step, const Shine& shine) {
             return std::pow(h_of(place, step, shine), step.ready->shininess) *
                    (step.material->kd * (step.material->specular_color * arriving(shine)));
         };
     }},
    {"lit.componentwise_dot", "N * L is multiplied component by component instead of n . L.", topic,
     [](Laws& laws) {
         laws.diffuse = [](const Place&, const Step& step, const Shine& shine) {
             const Vec p = step.normal * shine.towards;
             return Spectrum(p.x, p.y, p.z) * (step.ready->diffuse * arriving(shine));
         };
     }},
    {"lit.diffuse_missing", "Diffuse light is missing.", topic,
     [](Laws& laws) {
         laws.diffuse = [](const Place&, const Step&, const Shine&) { return Spectrum(0.0); };
     }},
    {"lit.spec_missing", "Highlights are missing.", topic,
     [](Laws& laws) {
         laws.specular = [](const Place&, const Step&, const Shine&) { return Spectrum(0.0); };
     }},
    {"lit.averaged_over_lights", "The lights are averaged and not added.", topic,
     [](Laws& laws) {
         scale_by(laws, [](const Place& place, const Step&, const Shine&) {
             return 1.0 / static_cast<double>(place.lights.size());
         });
     }},
    {"lit.only_last_light", "Only the last light counts: each overwrites the one before.", topic,
     [](Laws& laws) {
         scale_by(laws, [](const Place& place, const Step&, const Shine& shine) {
             return shine.light + 1 == place.lights.size() ? 1.0 : 0.0;
         });
     }},
    {"lit.only_first_light", "Only the first light counts.", topic,
     [](Laws& laws) {
         scale_by(laws, [](const Place&, const Step&, const Shine& shine) {
             return shine.light == 0 ? 1.0 : 0.0;
         });
     }},
    {"lit.clamped_early", "Local light is clamped to 1 before reflections are added.", topic,
     [](Laws& laws) {
         laws.combine = [](const Place& place, const Step& step, const Terms& terms) {
             const Spectrum sum = terms.ambient + terms.diffuse + terms.specular;
             Terms clamped = terms;
             clamped.diffuse = clamped.specular = Spectrum(0.0);
             clamped.ambient = {std::min(1.0, sum.r), std::min(1.0, sum.g), std::min(1.0, sum.b)};
             return model::combine(place, step, clamped);
         };
     }},
    {"lit.local_tinted_twice", "Local light is multiplied by the surface's colour once more.",
     topic,
     [](Laws& laws) {
         laws.combine = [](const Place& place, const Step& step, const Terms& terms) {
             Terms tinted = terms;
             for (Spectrum* term : {&tinted.ambient, &tinted.diffuse, &tinted.specular}) {
                 *term *= step.material->color;
             }
             return model::combine(place, step, tinted);
         };
     }},
};

}  // namespace

std::span<const MistakeRow> light_mistakes() { return rows; }

}  // namespace raytree::check
