#include <algorithm>
#include <cmath>

#include "check/catalogue.h"
#include "trace/shading.h"

namespace raytree::check {
namespace {

constexpr std::string_view topic = "recursion";

constexpr int most_levels = 64;  // of any tree

template <int more> std::optional<Reason> deeper(const Place& place, const Step& step, RayKind kind,
                                                 const Spectrum& weight) {
    Step other = step;
    other.level = step.level - more;
    return model::why_not(place, other, kind, weight);
}

/// Local light as a share of what `k` leaves.
Terms less_local(const Terms& terms, const Spectrum& k) {
    Terms less = terms;
    for (Spectrum* term : {&less.ambient, &less.diffuse, &less.specular}) {
        *term *= Spectrum(1 - k.r, 1 - k.g, 1 - k.b);
    }
    return less;
}

/// Where a branch is grown, its light alone.
Terms without_local(const Terms& terms) {
    Terms bare = terms;
    if (terms.reflected.grown || terms.refracted.grown) {
        bare.ambient = bare.diffuse = bare.specular = Spectrum(0.0);
    }
    return bare;
}

const MistakeRow rows[] = {
    {"rec.depth_plus_one", "The tree is one level too deep.", topic,
     [](Laws& laws) { laws.why_not = deeper<1>; }},
    {"rec.depth_minus_one", "The tree is one level too shallow.", topic,
     [](Laws& laws) { laws.why_not = deeper<-1>; }},
    {"rec.depth_shared_by_siblings",
     "What the reflected branch has counted, ++depth, the refracted branch has lost.", topic,
     [](Laws& laws) {
         laws.level = [](const Place& place, const Step& step, RayKind kind) {
             const bool second = kind == RayKind::refracted &&
                                 !model::why_not(place, step, RayKind::reflected,
                                                 model::weight(step, RayKind::reflected));
             return step.level + (second ? 2 : 1);
         };
     }},
    {"rec.min_weight_ignored", "Branches of small weight are not cut off.", topic,
     [](Laws& laws) {
         laws.why_not = [](const Place& place, const Step& step, RayKind kind,
                           const Spectrum& weight) {
             return model::why_not(place, step, kind,
                                   Spectrum(std::max(1.0, largest_component(weight))));
         };
     }},
    {"rec.never_ends",
     "What a branch adds is not made less by its coefficient: the tree does not end by itself.",
     topic,
     [](Laws& laws) { laws.weight = [](const Step& step, RayKind) { return step.weight; }; },
     {[](Laws& laws) {
         laws.weight = [](const Step& step, RayKind) { return step.weight; };
         laws.why_not = [](const Place& place, const Step& step, RayKind kind,
                           const Spectrum& weight) {
             Step first = step;
             first.level = step.level < most_levels ? 0 : place.scene().settings.max_depth;
             return model::why_not(place, first, kind,
                                   Spectrum(std::max(1.0, largest_component(weight))));
         };
     }}},
    {"rec.max_distance_ignored", "Rays are not ended by the greatest distance.", topic,
     [](Laws& laws) {
         laws.interval = [](const Place& place, const Step& step) {
             Interval<double> interval = model::interval(place, step);
             interval.to = Real<double>::infinity;
             return interval;
         };
     }},
    {"rec.distance_per_ray", "The greatest distance is applied to each ray, not to its path.",
     topic,
     [](Laws& laws) {
         laws.interval = [](const Place& place, const Step& step) {
             Step fresh = step;
             fresh.path = 0;
             return model::interval(place, fresh);
         };
     }},
    {"rec.fade_missing", "Reflected and refracted rays do not fade with distance.", topic,
     [](Laws& laws) { laws.fade = [](const Place&, const Step&) { return 1.0; }; }},
    {"rec.fade_on_primary", "The primary ray fades with distance too.", topic,
     [](Laws& laws) {
         laws.fade = [](const Place& place, const Step& step) {
             return place.attenuation.at(step.t);
         };
     }},
    {"rec.fade_by_path", "Rays fade with the whole path and not with their own length.", topic,
     [](Laws& laws) {
         laws.fade = [](const Place& place, const Step& step) {
             return step.kind == RayKind::primary ? 1.0 : place.attenuation.at(step.path + step.t);
         };
     }},
    {"num.nan",
     "A number is none: 0 is divided by 0, a vector of length 0 made unit, the root taken of a "
     "negative number, or a value used that is not there.",
     "the limits of numbers", [](Laws&) {}},
    {"rec.lerp",
     "Reflection replaces local light: (1 - kr) local is added, or (1 - kr - kt) local.",
     topic,
     [](Laws& laws) {
         laws.combine = [](const Place& place, const Step& step, const Terms& terms) {
             return model::combine(place, step, less_local(terms, step.kr));
         };
     },
     {[](Laws& laws) {
          laws.combine = [](const Place& place, const Step& step, const Terms& terms) {
              return model::combine(place, step, less_local(terms, step.ready->kr));
          };
      },
      [](Laws& laws) {
          laws.combine = [](const Place& place, const Step& step, const Terms& terms) {
              const bool mirrors = terms.reflected.grown;
              return model::combine(place, step,
                                    mirrors ? less_local(terms, step.ready->kr) : terms);
          };
      },
      [](Laws& laws) {
          laws.combine = [](const Place& place, const Step& step, const Terms& terms) {
              return model::combine(place, step, less_local(terms, step.kr + step.kt));
          };
      }}},
    {"rec.complement_missing",
     "Local light is added whole where the course adds what reflection leaves of it.", topic,
     [](Laws& laws) { laws.combine = model::combine; }},
    {"rec.overwrites",
     "What is reflected or refracted overwrites local light.",
     topic,
     [](Laws& laws) {
         laws.combine = [](const Place& place, const Step& step, const Terms& terms) {
             return model::combine(place, step, without_local(terms));
         };
     },
     {[](Laws& laws) {
         laws.combine = [](const Place& place, const Step& step, const Terms& terms) {
             Terms last = without_local(terms);
             last.reflected.grown = terms.reflected.grown && !terms.refracted.grown;
             return model::combine(place, step, last);
         };
     }}},
    {"rec.last_branch_only", "The refracted light overwrites the reflected.", topic,
     [](Laws& laws) {
         laws.combine = [](const Place& place, const Step& step, const Terms& terms) {
             Terms last = terms;
             last.reflected.grown = terms.reflected.grown && !terms.refracted.grown;
             return model::combine(place, step, last);
         };
     }},
    {"rec.multiplied", "What is reflected multiplies local light instead of adding to it.", topic,
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
    {"rec.averaged",
     "Local and reflected light are averaged.",
     topic,
     [](Laws& laws) {
         laws.combine = [](const Place& place, const Step& step, const Terms& terms) {
             const bool any = terms.reflected.grown || terms.refracted.grown;
             return (any ? 0.5 : 1.0) * model::combine(place, step, terms);
         };
     },
     {[](Laws& laws) {
         laws.combine = [](const Place& place, const Step& step, const Terms& terms) {
             const int all = 1 + int{terms.reflected.grown} + int{terms.refracted.grown};
             return (1.0 / all) * model::combine(place, step, terms);
         };
     }}},
    {"bg.black_for_secondary", "Secondary rays that hit nothing are black.", topic,
     [](Laws& laws) {
         laws.miss = [](const Place& place, const Step& step) {
             return step.kind == RayKind::primary ? model::miss(place, step) : Spectrum(0.0);
         };
     }},
    {"bg.background_for_secondary", "Secondary misses have the background of primary ones.", topic,
     [](Laws& laws) {
         laws.miss = [](const Place& place, const Step&) { return place.background; };
     }},
    {"bg.secondary_ambient", "Secondary misses are multiplied by the scene's ambient light.", topic,
     [](Laws& laws) {
         laws.miss = [](const Place& place, const Step& step) {
             const Spectrum miss = model::miss(place, step);
             return step.kind == RayKind::primary ? miss : place.scene().ambient * miss;
         };
     }},
    {"bg.ambient_for_miss", "Rays that hit nothing have the ambient colour.", topic,
     [](Laws& laws) {
         laws.miss = [](const Place& place, const Step&) { return place.scene().ambient; };
     }},
    {"bg.black", "Rays that hit nothing are black.", topic,
     [](Laws& laws) { laws.miss = [](const Place&, const Step&) { return Spectrum(0.0); }; }},
    {"bg.added_to_hits", "The background is added to what is hit.", topic,
     [](Laws& laws) {
         laws.combine = [](const Place& place, const Step& step, const Terms& terms) {
             return place.background + model::combine(place, step, terms);
         };
     }},
    {"out.child_clamped", "Intensities are clamped to 1 at every level.", topic,
     [](Laws& laws) {
         laws.combine = [](const Place& place, const Step& step, const Terms& terms) {
             const Spectrum sum = model::combine(place, step, terms);
             return Spectrum(std::min(1.0, sum.r), std::min(1.0, sum.g), std::min(1.0, sum.b));
         };
     }},
    {"out.gamma_each_level", "A gamma curve is applied at every level.", topic,
     [](Laws& laws) {
         laws.combine = [](const Place& place, const Step& step, const Terms& terms) {
             const Spectrum sum = model::combine(place, step, terms);
             const auto bent = [](double x) { return std::pow(std::max(0.0, x), 1 / 2.2); };
             return Spectrum(bent(sum.r), bent(sum.g), bent(sum.b));
         };
     }},
    {"out.bgr_each_level", "Red and blue are exchanged.", topic,
     [](Laws& laws) {
         laws.combine = [](const Place& place, const Step& step, const Terms& terms) {
             const Spectrum sum = model::combine(place, step, terms);
             return Spectrum(sum.b, sum.g, sum.r);
         };
     }},
};

}  // namespace

std::span<const MistakeRow> recursion_mistakes() { return rows; }

}  // namespace raytree::check
