#include <algorithm>

#include "check/catalogue.h"
#include "check/light_laws.h"

namespace raytree::check {
namespace {

constexpr std::string_view topic = "local illumination";

/// The light with its fading exchanged.
template <class Fade> void fade_by(Laws& laws, Fade) {
    laws.diffuse = [](const Place& place, const Step& step, const Shine& shine) {
        return Fade{}(shine) / fading(shine) * model::diffuse(place, step, shine);
    };
    laws.specular = [](const Place& place, const Step& step, const Shine& shine) {
        return Fade{}(shine) / fading(shine) * model::specular(place, step, shine);
    };
}

double fall_off(double a, double b, double c, double d) {
    return std::min(1.0, 1 / (a + b * d + c * d * d));
}

const MistakeRow rows[] = {
    {"lit.att_missing", "Lights do not fade with distance.", topic,
     [](Laws& laws) { fade_by(laws, [](const Shine&) { return 1.0; }); }},
    {"lit.att_twice", "Lights fade twice: the factor is squared.", topic,
     [](Laws& laws) {
         fade_by(laws, [](const Shine& shine) { return fading(shine) * fading(shine); });
     }},
    {"lit.att_d4",
     "Lights fade by d squared where d belongs.",
     topic,
     [](Laws& laws) {
         fade_by(laws, [](const Shine& shine) {
             const auto& f = shine.ready->attenuation;
             const double d = shine.distance;
             return shine.ready->directional ? 1.0 : fall_off(f.a, f.b, f.c, d * d);
         });
     },
     {[](Laws& laws) {
          fade_by(laws, [](const Shine& shine) {
              const double d = shine.distance;
              return shine.ready->directional ? 1.0 : std::min(1.0, 1 / (d * d * d * d));
          });
      },
      [](Laws& laws) {
          fade_by(laws, [](const Shine& shine) {
              const auto& f = shine.ready->attenuation;
              const double d = shine.distance;
              return shine.ready->directional ? 1.0 : fall_off(f.a, f.b, f.c * d * d, d);
          });
      }}},
    {"lit.att_swapped", "The linear and the quadratic coefficient of a light are exchanged.", topic,
     [](Laws& laws) {
         fade_by(laws, [](const Shine& shine) {
             const auto& f = shine.ready->attenuation;
             return shine.ready->directional ? 1.0 : fall_off(f.a, f.c, f.b, shine.distance);
         });
     }},
    {"lit.att_no_square", "The quadratic coefficient is multiplied by d and not by d squared.",
     topic,
     [](Laws& laws) {
         fade_by(laws, [](const Shine& shine) {
             const auto& f = shine.ready->attenuation;
             return shine.ready->directional ? 1.0 : fall_off(f.a, f.b + f.c, 0, shine.distance);
         });
     }},
    {"lit.att_inverse_square", "Lights fade with 1 / d^2, whatever the scene says.", topic,
     [](Laws& laws) {
         fade_by(laws, [](const Shine& shine) {
             return shine.ready->directional ? 1.0 : 1 / (shine.distance * shine.distance);
         });
     }},
    {"lit.att_unclamped", "The factor of fading is not limited to 1.", topic,
     [](Laws& laws) {
         fade_by(laws, [](const Shine& shine) {
             const auto& f = shine.ready->attenuation;
             const double d = shine.distance;
             return shine.ready->directional ? 1.0 : 1 / (f.a + f.b * d + f.c * d * d);
         });
     }},
};

}  // namespace

std::span<const MistakeRow> fading_mistakes() { return rows; }

}  // namespace raytree::check
