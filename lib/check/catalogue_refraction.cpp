#include <algorithm>
#include <cmath>

#include "check/branch_laws.h"
#include "check/catalogue.h"
#include "check/not_unit.h"
#include "trace/shading.h"

namespace raytree::check {
namespace {

constexpr std::string_view topic = "refraction";

double ratio(const Step& step) { return step.eta1 / step.eta2; }
double root(const Step& step) { return std::sqrt(std::max(0.0, step.cos2_transmitted)); }

Spectrum rest_of(const Spectrum& k) { return {1 - k.r, 1 - k.g, 1 - k.b}; }

/// A direction of no numbers meets nothing.
template <bool total_only> void without_numbers(Laws& laws) {
    laws.why_not = through_total;
    laws.meet = [](const Place& place, const Step& step, Interval<double> interval) {
        const bool none = step.kind == RayKind::refracted && step.parent &&
                          (!total_only || step.parent->total_reflection());
        return none ? std::nullopt : model::meet(place, step, interval);
    };
}

const MistakeRow rows[] = {
    {"refr.eta_inverted", "The ratio of the indices is upside down: n2 / n1.", topic,
     [](Laws& laws) {
         laws.indices = [](const Place& place, const Step& step) {
             const Indices at = model::indices(place, step);
             return Indices{at.eta2, at.eta1};
         };
     }},
    {"refr.eta_same_on_exit", "The ratio of the indices is not inverted on leaving.", topic,
     [](Laws& laws) {
         laws.indices = [](const Place& place, const Step& step) {
             const Indices at = model::indices(place, step);
             return step.front ? at : Indices{at.eta2, at.eta1};
         };
     }},
    {"refr.eta_inverted_on_entry", "The ratio of the indices is upside down on entering only.",
     topic,
     [](Laws& laws) {
         laws.indices = [](const Place& place, const Step& step) {
             const Indices at = model::indices(place, step);
             return step.front ? Indices{at.eta2, at.eta1} : at;
         };
     }},
    {"refr.eta_is_ior", "The ratio of the indices is always the material's index.", topic,
     [](Laws& laws) {
         laws.indices = [](const Place&, const Step& step) { return Indices{step.ready->ior, 1}; };
     }},
    {"refr.nested_media", "Outside is always taken for air, inside another medium too.", topic,
     [](Laws& laws) {
         laws.indices = [](const Place&, const Step& step) {
             return step.front ? Indices{1, step.ready->ior} : Indices{step.ready->ior, 1};
         };
     }},
    {"refr.eta_squared", "The ratio of the indices is squared.", topic,
     [](Laws& laws) {
         laws.indices = [](const Place& place, const Step& step) {
             const Indices at = model::indices(place, step);
             return Indices{at.eta1 * at.eta1, at.eta2 * at.eta2};
         };
     }},
    {"refr.normal_not_flipped", "The normal is not turned inside when the ray is bent.", topic,
     [](Laws& laws) {
         laws.refracted = [](const Place&, const Step& step) {
             const Vec n = step.front ? step.normal : -step.normal;
             const double c = -inner(step.direction, n);
             return ratio(step) * step.direction + (ratio(step) * c - root(step)) * n;
         };
     }},
    {"refr.uses_V", "V is used for d: the ray goes backwards.", topic,
     [](Laws& laws) {
         laws.refracted = [](const Place&, const Step& step) {
             return mixed(step, -ratio(step), ratio(step) * step.cosine() - root(step));
         };
     }},
    {"refr.cos_plus", "eta c1 + sqrt(k) is written for eta c1 - sqrt(k).", topic,
     [](Laws& laws) {
         laws.refracted = [](const Place&, const Step& step) {
             return mixed(step, ratio(step), ratio(step) * step.cosine() + root(step));
         };
     }},
    {"refr.cos_sign", "c1 has the wrong sign: -eta c1 - sqrt(k).", topic,
     [](Laws& laws) {
         laws.refracted = [](const Place&, const Step& step) {
             return mixed(step, ratio(step), -ratio(step) * step.cosine() - root(step));
         };
     }},
    {"refr.no_sqrt", "The square root of 1 - s2 is not taken.", topic,
     [](Laws& laws) {
         laws.refracted = [](const Place&, const Step& step) {
             return mixed(step, ratio(step), ratio(step) * step.cosine() - step.cos2_transmitted);
         };
     }},
    {"refr.watt_div_eta2",
     "A misprint of a textbook: the root is divided by eta squared.",
     topic,
     [](Laws& laws) {
         laws.refracted = [](const Place&, const Step& step) {
             const double eta = ratio(step);
             const double k = 1 - (1 - step.cosine() * step.cosine()) / (eta * eta);
             return mixed(step, eta, eta * step.cosine() - std::sqrt(std::max(0.0, k)));
         };
     },
     {[](Laws& laws) {
         laws.refracted = [](const Place&, const Step& step) {
             const double eta = ratio(step);
             return mixed(step, eta, eta * step.cosine() - root(step) / (eta * eta));
         };
     }}},
    {"refr.eta_missing_in_b", "eta is missing before c1.", topic,
     [](Laws& laws) {
         laws.refracted = [](const Place&, const Step& step) {
             return mixed(step, ratio(step), step.cosine() - root(step));
         };
     }},
    {"refr.eta_missing_in_a", "eta is missing before d.", topic,
     [](Laws& laws) {
         laws.refracted = [](const Place&, const Step& step) {
             return mixed(step, 1, ratio(step) * step.cosine() - root(step));
         };
     }},
    {"refr.eta_not_squared", "eta is not squared in 1 - eta^2 (1 - c1^2).", topic,
     [](Laws& laws) {
         laws.refracted = [](const Place&, const Step& step) {
             const double c = step.cosine();
             const double k = 1 - ratio(step) * (1 - c * c);
             return mixed(step, ratio(step), ratio(step) * c - std::sqrt(std::max(0.0, k)));
         };
     }},
    {"refr.c1_not_squared", "c1 is not squared in 1 - eta^2 (1 - c1^2).", topic,
     [](Laws& laws) {
         laws.refracted = [](const Place&, const Step& step) {
             const double c = step.cosine();
             const double k = 1 - ratio(step) * ratio(step) * (1 - c);
             return mixed(step, ratio(step), ratio(step) * c - std::sqrt(std::max(0.0, k)));
         };
     }},
    {"refr.straight", "The refracted ray is not bent.", topic,
     [](Laws& laws) {
         laws.refracted = [](const Place&, const Step& step) { return step.direction; };
     }},
    {"refr.reflected", "The refracted ray is reflected.", topic,
     [](Laws& laws) { laws.refracted = model::reflected; }},
    {"refr.along_normal", "The refracted ray goes along the normal.", topic,
     [](Laws& laws) {
         laws.refracted = [](const Place&, const Step& step) { return -step.normal; };
     }},
    {"refr.tir_abs", "Under total reflection the root is taken of |k|: there is a ray.", topic,
     [](Laws& laws) {
         laws.why_not = through_total;
         laws.refracted = [](const Place&, const Step& step) {
             return mixed(step, ratio(step),
                          ratio(step) * step.cosine() - std::sqrt(abs(step.cos2_transmitted)));
         };
     }},
    {"refr.tir_zero", "Under total reflection k is set to 0: a ray along the surface.", topic,
     [](Laws& laws) {
         laws.why_not = through_total;
         laws.refracted = grazing_where_total;
     }},
    {"refr.tir_nan",
     "Under total reflection the root is taken of a negative number: the ray has no direction.",
     topic, without_numbers<true>},
    {"refr.library_mismatch",
     "The refracted direction has no numbers: a library's function wants or gives something else.",
     topic, without_numbers<false>},
    {"refr.not_normalised", "Snell's law is used with a direction that is not unit.", topic,
     [](Laws& laws) {
         laws.primary = primary_not_unit;
         laws.refracted = refracted_not_unit;
     }},
    {"refr.tir_straight", "Under total reflection the ray goes on straight.", topic,
     [](Laws& laws) {
         laws.why_not = through_total;
         laws.refracted = [](const Place& place, const Step& step) {
             return step.total_reflection() ? step.direction : model::refracted(place, step);
         };
     }},
    {"refr.tir_as_refracted", "Under total reflection the refracted ray is sent mirrored.", topic,
     [](Laws& laws) {
         laws.why_not = through_total;
         laws.refracted = [](const Place& place, const Step& step) {
             return step.total_reflection() ? model::reflected(place, step)
                                            : model::refracted(place, step);
         };
     }},
    {"refr.tir_black", "Under total reflection kt is not added to kr, or is, against the scene.",
     topic,
     [](Laws& laws) {
         laws.coefficient = [](const Place& place, const Step& step, RayKind kind) {
             if (kind == RayKind::refracted || !step.total_reflection()) {
                 return model::coefficient(place, step, kind);
             }
             const bool adds =
                 place.scene().settings.total_internal_reflection == TotalReflection::reflect;
             return adds ? step.ready->kr : step.ready->kr + step.ready->kt;
         };
     }},
    {"refr.tir_full", "Under total reflection kr is set to 1.", topic,
     [](Laws& laws) {
         laws.coefficient = [](const Place& place, const Step& step, RayKind kind) {
             return kind == RayKind::reflected && step.total_reflection()
                        ? Spectrum(1.0)
                        : model::coefficient(place, step, kind);
         };
     }},
    {"refr.no_offset",
     "The refracted ray meets the surface that it starts on.",
     topic,
     [](Laws& laws) { laws.meet = own_surface<RayKind::refracted>; },
     {may_meet_own_start<RayKind::refracted>}},
    {"refr.offset_outside",
     "The refracted ray starts a little before the surface and meets it again.", topic,
     on_the_wrong_side<RayKind::refracted>},
    {"refr.from_eye", "The refracted ray starts at the eye.", topic,
     [](Laws& laws) { laws.start = from_eye<RayKind::refracted>; }},
    {"refr.kt_missing", "What is refracted is not multiplied by kt.", topic,
     [](Laws& laws) {
         share_by<RayKind::refracted>(laws,
                                      [](const Step&, const Spectrum&) { return Spectrum(1.0); });
     }},
    {"refr.kt_squared", "What is refracted is multiplied by kt twice.", topic,
     [](Laws& laws) {
         share_by<RayKind::refracted>(laws, [](const Step&, const Spectrum& k) { return k * k; });
     }},
    {"refr.one_minus",
     "What is refracted is multiplied by 1 - kr, or 1 - kt, instead of kt.",
     topic,
     [](Laws& laws) {
         share_by<RayKind::refracted>(
             laws, [](const Step& step, const Spectrum&) { return rest_of(step.material->kr); });
     },
     {[](Laws& laws) {
         share_by<RayKind::refracted>(laws,
                                      [](const Step&, const Spectrum& k) { return rest_of(k); });
     }}},
    {"refr.kr_for_kt", "What is refracted is multiplied by kr instead of kt.", topic,
     [](Laws& laws) {
         share_by<RayKind::refracted>(
             laws, [](const Step& step, const Spectrum&) { return step.material->kr; });
     }},
    {"refr.times_base", "What is refracted takes the surface's colour.", topic,
     [](Laws& laws) {
         share_by<RayKind::refracted>(
             laws, [](const Step& step, const Spectrum& k) { return step.material->color * k; });
     }},
    {"refr.not_added", "What is refracted is traced but not added.", topic,
     [](Laws& laws) {
         share_by<RayKind::refracted>(laws,
                                      [](const Step&, const Spectrum&) { return Spectrum(0.0); });
     }},
    {"refr.only_outside", "Nothing is refracted on the way out.", topic,
     [](Laws& laws) { laws.why_not = without<RayKind::refracted, true>; }},
    {"refr.missing_child", "No refracted rays are sent.", topic,
     [](Laws& laws) { laws.why_not = without<RayKind::refracted, false>; }},
};

}  // namespace

std::span<const MistakeRow> refraction_mistakes() { return rows; }

}  // namespace raytree::check
