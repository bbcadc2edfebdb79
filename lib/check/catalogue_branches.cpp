#include <algorithm>
#include <cmath>

#include "check/catalogue.h"
#include "trace/shading.h"

namespace raytree::check {
namespace {

constexpr std::string_view reflection = "reflection";
constexpr std::string_view refraction = "refraction";
constexpr std::string_view recursion = "recursion";

/// `a d + b n`.
Vec mixed(const Step& step, double a, double b) { return a * step.direction + b * step.normal; }

double ratio(const Step& step) { return step.eta1 / step.eta2; }
double root(const Step& step) { return std::sqrt(std::max(0.0, step.cos2_transmitted)); }

/// The tree is that of the right coefficient; what its branch adds is not.
template <RayKind kind, class Change> void share_by(Laws& laws, Change) {
    laws.combine = [](const Place& place, const Step& step, const Terms& terms) {
        Terms changed = terms;
        Terms::Branch& branch = kind == RayKind::reflected ? changed.reflected : changed.refracted;
        branch.coefficient = Change{}(step, branch.coefficient);
        return model::combine(place, step, changed);
    };
}

template <RayKind kind> std::optional<Hit<double>> own_surface(const Place& place, const Step& step,
                                                               Interval<double> interval) {
    if (step.kind == kind && step.leaving != no_primitive) {
        return Hit<double>{0, step.leaving};
    }
    return model::meet(place, step, interval);
}

template <RayKind kind> Vec from_eye(const Place& place, const Step& step, RayKind of) {
    return of == kind ? place.scene().camera.eye : step.point;
}

std::optional<Reason> none_of(const Place& place, const Step& step, RayKind kind,
                              const Spectrum& weight, RayKind which, bool inside_only) {
    const auto reason = model::why_not(place, step, kind, weight);
    const bool stopped = kind == which && (!inside_only || !step.front);
    const Reason why =
        which == RayKind::reflected ? Reason::not_reflective : Reason::not_transmissive;
    return stopped ? std::optional(reason.value_or(why)) : reason;
}

template <RayKind which, bool inside_only>
std::optional<Reason> without(const Place& place, const Step& step, RayKind kind,
                              const Spectrum& weight) {
    return none_of(place, step, kind, weight, which, inside_only);
}

/// Total reflection does not stop the refracted ray.
std::optional<Reason> through_total(const Place& place, const Step& step, RayKind kind,
                                    const Spectrum& weight) {
    Step passing = step;
    passing.cos2_transmitted = 1;
    return model::why_not(place, passing, kind, weight);
}

template <int more> std::optional<Reason> deeper(const Place& place, const Step& step, RayKind kind,
                                                 const Spectrum& weight) {
    Step other = step;
    other.level = step.level - more;
    return model::why_not(place, other, kind, weight);
}

const MistakeRow reflection_rows[] = {
    {"refl.plus", "d + 2 (d . n) n is written for d - 2 (d . n) n.", reflection,
     [](Laws& laws) {
         laws.reflected = [](const Place&, const Step& step) {
             return mixed(step, 1, -2 * step.cosine());
         };
     }},
    {"refl.no_factor2", "The factor 2 is missing: the ray slides along the surface.", reflection,
     [](Laws& laws) {
         laws.reflected = [](const Place&, const Step& step) {
             return mixed(step, 1, step.cosine());
         };
     }},
    {"refl.reversed", "The reflected ray is reversed: 2 (n . d) n - d.", reflection,
     [](Laws& laws) {
         laws.reflected = [](const Place&, const Step& step) {
             return mixed(step, -1, -2 * step.cosine());
         };
     }},
    {"refl.componentwise", "d * n is multiplied component by component instead of d . n.",
     reflection,
     [](Laws& laws) {
         laws.reflected = [](const Place&, const Step& step) {
             return step.direction - 2.0 * (step.direction * step.normal) * step.normal;
         };
     }},
    {"refl.swapped_args", "The arguments of reflect are exchanged: n - 2 (n . d) d.", reflection,
     [](Laws& laws) {
         laws.reflected = [](const Place&, const Step& step) {
             return mixed(step, 2 * step.cosine(), 1);
         };
     }},
    {"refl.along_normal", "The reflected ray goes along the normal.", reflection,
     [](Laws& laws) {
         laws.reflected = [](const Place&, const Step& step) { return step.normal; };
     }},
    {"refl.backwards", "The reflected ray goes back where it came from.", reflection,
     [](Laws& laws) {
         laws.reflected = [](const Place&, const Step& step) { return -step.direction; };
     }},
    {"refl.straight", "The reflected ray goes on straight.", reflection,
     [](Laws& laws) {
         laws.reflected = [](const Place&, const Step& step) { return step.direction; };
     }},
    {"refl.uses_point", "The hit point is used for the normal.", reflection,
     [](Laws& laws) {
         laws.reflected = [](const Place&, const Step& step) {
             const Vec n = model::unit(step.point);
             return step.direction - 2 * inner(step.direction, n) * n;
         };
     }},
    {"refl.no_offset", "The reflected ray meets the surface that it starts on.", reflection,
     [](Laws& laws) { laws.meet = own_surface<RayKind::reflected>; }},
    {"refl.from_eye", "The reflected ray starts at the eye.", reflection,
     [](Laws& laws) { laws.start = from_eye<RayKind::reflected>; }},
    {"refl.kr_missing", "What is reflected is not multiplied by kr.", reflection,
     [](Laws& laws) {
         share_by<RayKind::reflected>(laws,
                                      [](const Step&, const Spectrum&) { return Spectrum(1.0); });
     }},
    {"refl.kr_squared", "What is reflected is multiplied by kr twice.", reflection,
     [](Laws& laws) {
         share_by<RayKind::reflected>(laws, [](const Step&, const Spectrum& k) { return k * k; });
     }},
    {"refl.times_base", "What is reflected takes the surface's colour.", reflection,
     [](Laws& laws) {
         share_by<RayKind::reflected>(
             laws, [](const Step& step, const Spectrum& k) { return step.material->color * k; });
     }},
    {"refl.ks_for_kr", "What is reflected is multiplied by ks instead of kr.", reflection,
     [](Laws& laws) {
         share_by<RayKind::reflected>(
             laws, [](const Step& step, const Spectrum&) { return step.material->ks; });
     }},
    {"refl.kt_for_kr", "What is reflected is multiplied by kt instead of kr.", reflection,
     [](Laws& laws) {
         share_by<RayKind::reflected>(
             laws, [](const Step& step, const Spectrum&) { return step.material->kt; });
     }},
    {"refl.not_added", "What is reflected is traced but not added.", reflection,
     [](Laws& laws) {
         share_by<RayKind::reflected>(laws,
                                      [](const Step&, const Spectrum&) { return Spectrum(0.0); });
     }},
    {"refl.only_outside", "Nothing is reflected on the inside of a surface.", reflection,
     [](Laws& laws) { laws.why_not = without<RayKind::reflected, true>; }},
    {"refl.missing_child", "No reflected rays are sent.", reflection,
     [](Laws& laws) { laws.why_not = without<RayKind::reflected, false>; }},
};

const MistakeRow refraction_rows[] = {
    {"refr.eta_inverted", "The ratio of the indices is upside down: n2 / n1.", refraction,
     [](Laws& laws) {
         laws.indices = [](const Place& place, const Step& step) {
             const Indices at = model::indices(place, step);
             return Indices{at.eta2, at.eta1};
         };
     }},
    {"refr.eta_same_on_exit", "The ratio of the indices is not inverted on leaving.", refraction,
     [](Laws& laws) {
         laws.indices = [](const Place& place, const Step& step) {
             const Indices at = model::indices(place, step);
             return step.front ? at : Indices{at.eta2, at.eta1};
         };
     }},
    {"refr.eta_inverted_on_entry", "The ratio of the indices is upside down on entering only.",
     refraction,
     [](Laws& laws) {
         laws.indices = [](const Place& place, const Step& step) {
             const Indices at = model::indices(place, step);
             return step.front ? Indices{at.eta2, at.eta1} : at;
         };
     }},
    {"refr.nested_media", "Outside is always taken for air, inside another medium too.", refraction,
     [](Laws& laws) {
         laws.indices = [](const Place&, const Step& step) {
             return step.front ? Indices{1, step.ready->ior} : Indices{step.ready->ior, 1};
         };
     }},
    {"refr.eta_squared", "The ratio of the indices is squared.", refraction,
     [](Laws& laws) {
         laws.indices = [](const Place& place, const Step& step) {
             const Indices at = model::indices(place, step);
             return Indices{at.eta1 * at.eta1, at.eta2 * at.eta2};
         };
     }},
    {"refr.normal_not_flipped", "The normal is not turned inside when the ray is bent.", refraction,
     [](Laws& laws) {
         laws.refracted = [](const Place&, const Step& step) {
             const Vec n = step.front ? step.normal : -step.normal;
             const double c = -inner(step.direction, n);
             return ratio(step) * step.direction + (ratio(step) * c - root(step)) * n;
         };
     }},
    {"refr.uses_V", "V is used for d: the ray goes backwards.", refraction,
     [](Laws& laws) {
         laws.refracted = [](const Place&, const Step& step) {
             return mixed(step, -ratio(step), ratio(step) * step.cosine() - root(step));
         };
     }},
    {"refr.cos_plus", "eta c1 + sqrt(k) is written for eta c1 - sqrt(k).", refraction,
     [](Laws& laws) {
         laws.refracted = [](const Place&, const Step& step) {
             return mixed(step, ratio(step), ratio(step) * step.cosine() + root(step));
         };
     }},
    {"refr.cos_sign", "c1 has the wrong sign: -eta c1 - sqrt(k).", refraction,
     [](Laws& laws) {
         laws.refracted = [](const Place&, const Step& step) {
             return mixed(step, ratio(step), -ratio(step) * step.cosine() - root(step));
         };
     }},
    {"refr.no_sqrt", "The square root of 1 - s2 is not taken.", refraction,
     [](Laws& laws) {
         laws.refracted = [](const Place&, const Step& step) {
             return mixed(step, ratio(step), ratio(step) * step.cosine() - step.cos2_transmitted);
         };
     }},
    {"refr.watt_div_eta2", "A misprint of a textbook: the root is divided by eta squared.",
     refraction,
     [](Laws& laws) {
         laws.refracted = [](const Place&, const Step& step) {
             const double eta = ratio(step);
             const double k = 1 - (1 - step.cosine() * step.cosine()) / (eta * eta);
             return mixed(step, eta, eta * step.cosine() - std::sqrt(std::max(0.0, k)));
         };
     }},
    {"refr.eta_missing_in_b", "eta is missing before c1.", refraction,
     [](Laws& laws) {
         laws.refracted = [](const Place&, const Step& step) {
             return mixed(step, ratio(step), step.cosine() - root(step));
         };
     }},
    {"refr.eta_missing_in_a", "eta is missing before d.", refraction,
     [](Laws& laws) {
         laws.refracted = [](const Place&, const Step& step) {
             return mixed(step, 1, ratio(step) * step.cosine() - root(step));
         };
     }},
    {"refr.eta_not_squared", "eta is not squared in 1 - eta^2 (1 - c1^2).", refraction,
     [](Laws& laws) {
         laws.refracted = [](const Place&, const Step& step) {
             const double c = step.cosine();
             const double k = 1 - ratio(step) * (1 - c * c);
             return mixed(step, ratio(step), ratio(step) * c - std::sqrt(std::max(0.0, k)));
         };
     }},
    {"refr.c1_not_squared", "c1 is not squared in 1 - eta^2 (1 - c1^2).", refraction,
     [](Laws& laws) {
         laws.refracted = [](const Place&, const Step& step) {
             const double c = step.cosine();
             const double k = 1 - ratio(step) * ratio(step) * (1 - c);
             return mixed(step, ratio(step), ratio(step) * c - std::sqrt(std::max(0.0, k)));
         };
     }},
    {"refr.straight", "The refracted ray is not bent.", refraction,
     [](Laws& laws) {
         laws.refracted = [](const Place&, const Step& step) { return step.direction; };
     }},
    {"refr.reflected", "The refracted ray is reflected.", refraction,
     [](Laws& laws) { laws.refracted = model::reflected; }},
    {"refr.along_normal", "The refracted ray goes along the normal.", refraction,
     [](Laws& laws) {
         laws.refracted = [](const Place&, const Step& step) { return -step.normal; };
     }},
    {"refr.tir_abs", "Under total reflection the root is taken of |k|: there is a ray.", refraction,
     [](Laws& laws) {
         laws.why_not = through_total;
         laws.refracted = [](const Place&, const Step& step) {
             return mixed(step, ratio(step),
                          ratio(step) * step.cosine() - std::sqrt(abs(step.cos2_transmitted)));
         };
     }},
    {"refr.tir_zero", "Under total reflection k is set to 0: a ray along the surface.", refraction,
     [](Laws& laws) {
         laws.why_not = through_total;
         laws.refracted = [](const Place&, const Step& step) {
             return mixed(step, ratio(step), ratio(step) * step.cosine() - root(step));
         };
     }},
    {"refr.tir_straight", "Under total reflection the ray goes on straight.", refraction,
     [](Laws& laws) {
         laws.why_not = through_total;
         laws.refracted = [](const Place& place, const Step& step) {
             return step.total_reflection() ? step.direction : model::refracted(place, step);
         };
     }},
    {"refr.tir_as_refracted", "Under total reflection the refracted ray is sent mirrored.",
     refraction,
     [](Laws& laws) {
         laws.why_not = through_total;
         laws.refracted = [](const Place& place, const Step& step) {
             return step.total_reflection() ? model::reflected(place, step)
                                            : model::refracted(place, step);
         };
     }},
    {"refr.tir_black", "Under total reflection kt is not added to kr, or is, against the scene.",
     refraction,
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
    {"refr.tir_full", "Under total reflection kr is set to 1.", refraction,
     [](Laws& laws) {
         laws.coefficient = [](const Place& place, const Step& step, RayKind kind) {
             return kind == RayKind::reflected && step.total_reflection()
                        ? Spectrum(1.0)
                        : model::coefficient(place, step, kind);
         };
     }},
    {"refr.no_offset", "The refracted ray meets the surface that it starts on.", refraction,
     [](Laws& laws) { laws.meet = own_surface<RayKind::refracted>; }},
    {"refr.from_eye", "The refracted ray starts at the eye.", refraction,
     [](Laws& laws) { laws.start = from_eye<RayKind::refracted>; }},
    {"refr.kt_missing", "What is refracted is not multiplied by kt.", refraction,
     [](Laws& laws) {
         share_by<RayKind::refracted>(laws,
                                      [](const Step&, const Spectrum&) { return Spectrum(1.0); });
     }},
    {"refr.kt_squared", "What is refracted is multiplied by kt twice.", refraction,
     [](Laws& laws) {
         share_by<RayKind::refracted>(laws, [](const Step&, const Spectrum& k) { return k * k; });
     }},
    {"refr.one_minus", "What is refracted is multiplied by 1 - kr instead of kt.", refraction,
     [](Laws& laws) {
         share_by<RayKind::refracted>(laws, [](const Step& step, const Spectrum&) {
             const Spectrum& k = step.material->kr;
             return Spectrum(1 - k.r, 1 - k.g, 1 - k.b);
         });
     }},
    {"refr.one_minus_kt", "What is refracted is multiplied by 1 - kt instead of kt.", refraction,
     [](Laws& laws) {
         share_by<RayKind::refracted>(laws, [](const Step&, const Spectrum& k) {
             return Spectrum(1 - k.r, 1 - k.g, 1 - k.b);
         });
     }},
    {"refr.kr_for_kt", "What is refracted is multiplied by kr instead of kt.", refraction,
     [](Laws& laws) {
         share_by<RayKind::refracted>(
             laws, [](const Step& step, const Spectrum&) { return step.material->kr; });
     }},
    {"refr.times_base", "What is refracted takes the surface's colour.", refraction,
     [](Laws& laws) {
         share_by<RayKind::refracted>(
             laws, [](const Step& step, const Spectrum& k) { return step.material->color * k; });
     }},
    {"refr.not_added", "What is refracted is traced but not added.", refraction,
     [](Laws& laws) {
         share_by<RayKind::refracted>(laws,
                                      [](const Step&, const Spectrum&) { return Spectrum(0.0); });
     }},
    {"refr.only_outside", "Nothing is refracted on the way out.", refraction,
     [](Laws& laws) { laws.why_not = without<RayKind::refracted, true>; }},
    {"refr.missing_child", "No refracted rays are sent.", refraction,
     [](Laws& laws) { laws.why_not = without<RayKind::refracted, false>; }},
};

const MistakeRow recursion_rows[] = {
    {"rec.depth_plus_one", "The tree is one level too deep.", recursion,
     [](Laws& laws) { laws.why_not = deeper<1>; }},
    {"rec.depth_minus_one", "The tree is one level too shallow.", recursion,
     [](Laws& laws) { laws.why_not = deeper<-1>; }},
    {"rec.min_weight_ignored", "Branches of small weight are not cut off.", recursion,
     [](Laws& laws) {
         laws.why_not = [](const Place& place, const Step& step, RayKind kind,
                           const Spectrum& weight) {
             return model::why_not(place, step, kind,
                                   Spectrum(std::max(1.0, largest_component(weight))));
         };
     }},
    {"rec.max_distance_ignored", "Rays are not ended by the greatest distance.", recursion,
     [](Laws& laws) {
         laws.interval = [](const Place& place, const Step& step) {
             Interval<double> interval = model::interval(place, step);
             interval.to = Real<double>::infinity;
             return interval;
         };
     }},
    {"rec.distance_per_ray", "The greatest distance is applied to each ray, not to its path.",
     recursion,
     [](Laws& laws) {
         laws.interval = [](const Place& place, const Step& step) {
             Step fresh = step;
             fresh.path = 0;
             return model::interval(place, fresh);
         };
     }},
    {"rec.fade_missing", "Reflected and refracted rays do not fade with distance.", recursion,
     [](Laws& laws) { laws.fade = [](const Place&, const Step&) { return 1.0; }; }},
    {"rec.fade_on_primary", "The primary ray fades with distance too.", recursion,
     [](Laws& laws) {
         laws.fade = [](const Place& place, const Step& step) {
             return place.attenuation.at(step.t);
         };
     }},
    {"rec.fade_by_path", "Rays fade with the whole path and not with their own length.", recursion,
     [](Laws& laws) {
         laws.fade = [](const Place& place, const Step& step) {
             return step.kind == RayKind::primary ? 1.0 : place.attenuation.at(step.path + step.t);
         };
     }},
    {"rec.lerp", "Reflection replaces local light: (1 - kr) local is added.", recursion,
     [](Laws& laws) {
         laws.combine = [](const Place& place, const Step& step, const Terms& terms) {
             Terms less = terms;
             for (Spectrum* term : {&less.ambient, &less.diffuse, &less.specular}) {
                 *term *= Spectrum(1 - step.kr.r, 1 - step.kr.g, 1 - step.kr.b);
             }
             return model::combine(place, step, less);
         };
     }},
    {"rec.lerp_both", "Local light is multiplied by 1 - kr - kt.", recursion,
     [](Laws& laws) {
         laws.combine = [](const Place& place, const Step& step, const Terms& terms) {
             Terms less = terms;
             for (Spectrum* term : {&less.ambient, &less.diffuse, &less.specular}) {
                 *term *= Spectrum(1 - step.kr.r - step.kt.r, 1 - step.kr.g - step.kt.g,
                                   1 - step.kr.b - step.kt.b);
             }
             return model::combine(place, step, less);
         };
     }},
    {"rec.overwrites", "What is reflected or refracted overwrites local light.", recursion,
     [](Laws& laws) {
         laws.combine = [](const Place& place, const Step& step, const Terms& terms) {
             Terms bare = terms;
             if (terms.reflected.grown || terms.refracted.grown) {
                 bare.ambient = bare.diffuse = bare.specular = Spectrum(0.0);
             }
             return model::combine(place, step, bare);
         };
     }},
    {"rec.last_branch_only", "The refracted light overwrites the reflected.", recursion,
     [](Laws& laws) {
         laws.combine = [](const Place& place, const Step& step, const Terms& terms) {
             Terms last = terms;
             last.reflected.grown = terms.reflected.grown && !terms.refracted.grown;
             return model::combine(place, step, last);
         };
     }},
    {"rec.multiplied", "What is reflected multiplies local light instead of adding to it.",
     recursion,
     [](Laws& laws) {
         laws.combine = [](const Place&, const Step&, const Terms& terms) {
             Spectrum product = terms.ambient + terms.diffuse + terms.specular;
             for (const Terms::Branch& branch : {terms.reflected, terms.refracted}) {
                 if (branch.grown) {
                     product *= branch.attenuation * (branch.coefficient * branch.intensity);
                 }
             }
             return product;
         };
     }},
    {"rec.averaged", "Local and reflected light are averaged.", recursion,
     [](Laws& laws) {
         laws.combine = [](const Place& place, const Step& step, const Terms& terms) {
             const bool any = terms.reflected.grown || terms.refracted.grown;
             return (any ? 0.5 : 1.0) * model::combine(place, step, terms);
         };
     }},
    {"bg.black_for_secondary", "Secondary rays that hit nothing are black.", recursion,
     [](Laws& laws) {
         laws.miss = [](const Place& place, const Step& step) {
             return step.kind == RayKind::primary ? model::miss(place, step) : Spectrum(0.0);
         };
     }},
    {"bg.background_for_secondary", "Secondary misses have the background of primary ones.",
     recursion,
     [](Laws& laws) {
         laws.miss = [](const Place& place, const Step&) { return place.background; };
     }},
    {"bg.secondary_ambient", "Secondary misses are multiplied by the scene's ambient light.",
     recursion,
     [](Laws& laws) {
         laws.miss = [](const Place& place, const Step& step) {
             const Spectrum miss = model::miss(place, step);
             return step.kind == RayKind::primary ? miss : place.scene().ambient * miss;
         };
     }},
    {"bg.ambient_for_miss", "Rays that hit nothing have the ambient colour.", recursion,
     [](Laws& laws) {
         laws.miss = [](const Place& place, const Step&) { return place.scene().ambient; };
     }},
    {"bg.black", "Rays that hit nothing are black.", recursion,
     [](Laws& laws) { laws.miss = [](const Place&, const Step&) { return Spectrum(0.0); }; }},
    {"bg.added_to_hits", "The background is added to what is hit.", recursion,
     [](Laws& laws) {
         laws.combine = [](const Place& place, const Step& step, const Terms& terms) {
             return place.background + model::combine(place, step, terms);
         };
     }},
    {"out.child_clamped", "Intensities are clamped to 1 at every level.", recursion,
     [](Laws& laws) {
         laws.combine = [](const Place& place, const Step& step, const Terms& terms) {
             const Spectrum sum = model::combine(place, step, terms);
             return Spectrum(std::min(1.0, sum.r), std::min(1.0, sum.g), std::min(1.0, sum.b));
         };
     }},
    {"out.gamma_each_level", "A gamma curve is applied at every level.", recursion,
     [](Laws& laws) {
         laws.combine = [](const Place& place, const Step& step, const Terms& terms) {
             const Spectrum sum = model::combine(place, step, terms);
             const auto bent = [](double x) { return std::pow(std::max(0.0, x), 1 / 2.2); };
             return Spectrum(bent(sum.r), bent(sum.g), bent(sum.b));
         };
     }},
    {"out.bgr_each_level", "Red and blue are exchanged.", recursion,
     [](Laws& laws) {
         laws.combine = [](const Place& place, const Step& step, const Terms& terms) {
             const Spectrum sum = model::combine(place, step, terms);
             return Spectrum(sum.b, sum.g, sum.r);
         };
     }},
};

}  // namespace

std::span<const MistakeRow> reflection_mistakes() { return reflection_rows; }
std::span<const MistakeRow> refraction_mistakes() { return refraction_rows; }
std::span<const MistakeRow> recursion_mistakes() { return recursion_rows; }

}  // namespace raytree::check
