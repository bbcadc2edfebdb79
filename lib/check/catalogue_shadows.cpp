#include <algorithm>
#include <vector>

#include "check/branch_laws.h"
#include "check/catalogue.h"

namespace raytree::check {
namespace {

constexpr std::string_view topic = "shadows";

/// The hits that `counts` from `origin` towards `direction`, nearer than `distance`.
template <class Counts> std::vector<Hit<double>> between(const Place& place, const Vec& origin,
                                                         const Vec& direction, PrimitiveId leaving,
                                                         double distance, Counts counts) {
    NoTestCount none;
    const Interval<double> interval{0, distance * (1 - 8 * Real<double>::unit_roundoff)};
    const Ray<double> ray{origin, direction, model::origin_error(origin)};
    std::vector<Hit<double>> hits = place.shapes.all(ray, leaving, interval, none);
    std::erase_if(hits, [&](const Hit<double>& hit) { return !counts(hit); });
    return hits;
}

constexpr double offset_of_students = 1e-5;  // of the size of the point

bool any_hit(const Hit<double>&) { return true; }

bool wanted(const Place& place) { return place.scene().settings.shadows != ShadowMode::none; }

Passage up_to(const Place& place, const Step& step, const Shine& shine, double distance) {
    Shine other = shine;
    other.distance = distance;
    return model::shadow(place, step, other);
}

template <class Counts>
Passage only(const Place& place, const Step& step, const Shine& shine, Counts counts) {
    return wanted(place) ? model::through(place, between(place, step.point, shine.towards,
                                                         step.surface, shine.distance, counts))
                         : Passage{};
}

/// Whatever is met stops the light, glass too.
Passage stopped_by(const std::vector<Hit<double>>& hits) {
    return hits.empty() ? Passage{}
                        : Passage{Spectrum(0.0), hits.front().primitive, hits.front().t};
}

/// As a program finds it whose shadow rays start below the surface.
Passage from_below(const Place& place, const Shine& shine, const Vec& start) {
    return wanted(place) ? model::through(place, between(place, start, shine.towards, no_primitive,
                                                         shine.distance, any_hit))
                         : Passage{};
}

Vec put_on(const Step& step) {
    const double size = std::max(1.0, largest_component(step.point));
    return along(step.point, offset_of_students * size, step.direction);
}

Passage own_surface(const Place& place, const Step& step, const Shine&) {
    return wanted(place) ? Passage{Spectrum(0.0), step.primitive, 0} : Passage{};
}

std::size_t object_of(const Place& place, PrimitiveId primitive) {
    return place.shapes.shapes()[primitive].object;
}

const Material& material_of(const Place& place, PrimitiveId primitive) {
    return place.scene().materials[place.scene().objects[object_of(place, primitive)].material];
}

Passage inverted(const Place& place, const Step& step, const Shine& shine) {
    Passage passage = model::shadow(place, step, shine);
    if (wanted(place)) {
        const bool dark = is_zero(passage.transmittance);
        passage.transmittance = Spectrum(dark ? 1.0 : 0.0);
    }
    return passage;
}

/// The shadow ray goes the wrong way, and is handed in like that; the light is added rightly.
void shows_reversed(Laws& laws) {
    laws.sent = [](const Place&, const Step&, const Shine& shine) { return -shine.towards; };
    laws.shadow = [](const Place& place, const Step& step, const Shine& shine) {
        Shine other = shine;
        other.towards = -shine.towards;
        return model::shadow(place, step, other);
    };
}

/// The first object of the list that the ray meets decides, whether it lies before the light or
/// behind it.
Passage first_of_the_list(const Place& place, const Step& step, const Shine& shine) {
    const std::vector<Hit<double>> hits =
        between(place, step.point, shine.towards, step.surface, Real<double>::infinity, any_hit);
    if (!wanted(place) || hits.empty()) {
        return {};
    }
    const Hit<double> first = *std::ranges::min_element(hits, {}, &Hit<double>::primitive);
    return first.t < shine.distance ? model::through(place, std::vector{first}) : Passage{};
}

/// Of all that lies before the light the nearest alone counts.
Passage nearest_alone(const Place& place, const Step& step, const Shine& shine) {
    const std::vector<Hit<double>> hits =
        between(place, step.point, shine.towards, step.surface, shine.distance, any_hit);
    return wanted(place) && !hits.empty() ? model::through(place, std::vector{hits.front()})
                                          : Passage{};
}

const MistakeRow rows[] = {
    {"shd.missing", "There are no shadows: no light is ever blocked.", topic,
     [](Laws& laws) {
         laws.shadow = [](const Place&, const Step&, const Shine&) { return Passage{}; };
     }},
    {"shd.inverted", "Only what lies in shadow is lit.", topic,
     [](Laws& laws) { laws.shadow = inverted; }},
    {"shd.no_offset",
     "The shadow ray meets the surface that it starts on.",
     topic,
     [](Laws& laws) { laws.shadow = own_surface; },
     {may_meet_own_start<RayKind::shadow>}},
    {"shd.offset_along_dir_wrong_side",
     "The shadow ray starts a little further along the incoming ray, below the surface.", topic,
     [](Laws& laws) {
         laws.start = [](const Place&, const Step& step, RayKind kind) {
             return kind == RayKind::shadow ? put_on(step) : step.point;
         };
         laws.offset = [](const Step& step, RayKind kind) {
             return kind == RayKind::shadow ? step.direction : model::offset(step, kind);
         };
         laws.shadow = [](const Place& place, const Step& step, const Shine& shine) {
             return from_below(place, shine, put_on(step));
         };
     }},
    {"shd.from_light", "The shadow ray starts at the light and meets the lit surface itself.",
     topic,
     [](Laws& laws) {
         laws.shadow = [](const Place& place, const Step& step, const Shine& shine) {
             if (!wanted(place) || shine.ready->directional) {
                 return model::shadow(place, step, shine);
             }
             const Passage first =
                 stopped_by(between(place, shine.ready->position, Vec(-shine.towards), no_primitive,
                                    Real<double>::infinity, any_hit));
             return first.blocker == no_primitive
                        ? Passage{Spectrum(0.0), step.primitive, shine.distance}
                        : first;
         };
     }},
    {"shd.from_eye", "The shadow ray starts at the eye and not at the hit.", topic,
     [](Laws& laws) {
         laws.shadow = [](const Place& place, const Step&, const Shine& shine) {
             return wanted(place) ? model::through(place, between(place, place.scene().camera.eye,
                                                                  shine.towards, no_primitive,
                                                                  shine.distance, any_hit))
                                  : Passage{};
         };
     }},
    {"shd.unlimited", "Objects behind the light cast shadows too.", topic,
     [](Laws& laws) {
         laws.shadow = [](const Place& place, const Step& step, const Shine& shine) {
             return up_to(place, step, shine, Real<double>::infinity);
         };
     }},
    {"shd.unnormalised_tmax",
     "The light's distance limits a shadow ray whose direction is not unit.", topic,
     [](Laws& laws) {
         laws.shadow = [](const Place& place, const Step& step, const Shine& shine) {
             return up_to(place, step, shine, shine.distance * shine.distance);
         };
     }},
    {"shd.tmax_one_unit", "Only what is nearer than 1 blocks the light, though L is unit.", topic,
     [](Laws& laws) {
         laws.shadow = [](const Place& place, const Step& step, const Shine& shine) {
             return up_to(place, step, shine, std::min(1.0, shine.distance));
         };
     }},
    {"shd.reversed",
     "The shadow ray goes away from the light.",
     topic,
     [](Laws& laws) {
         laws.shadow = [](const Place& place, const Step& step, const Shine& shine) {
             Shine other = shine;
             other.towards = -shine.towards;
             return model::shadow(place, step, other);
         };
     },
     {shows_reversed}},
    {"shd.only_first_object", "Only the first object of the scene casts shadows.", topic,
     [](Laws& laws) {
         laws.shadow = [](const Place& place, const Step& step, const Shine& shine) {
             return only(place, step, shine, [&](const Hit<double>& hit) {
                 return object_of(place, hit.primitive) == 0;
             });
         };
     }},
    {"shd.skip_self", "An object never casts a shadow on itself.", topic,
     [](Laws& laws) {
         laws.shadow = [](const Place& place, const Step& step, const Shine& shine) {
             return only(place, step, shine, [&](const Hit<double>& hit) {
                 return object_of(place, hit.primitive) != object_of(place, step.primitive);
             });
         };
     }},
    {"shd.glass_casts_none", "Transparent objects cast no shadows.", topic,
     [](Laws& laws) {
         laws.shadow = [](const Place& place, const Step& step, const Shine& shine) {
             return only(place, step, shine, [&](const Hit<double>& hit) {
                 return is_zero(material_of(place, hit.primitive).kt);
             });
         };
     }},
    {"shd.glass_is_opaque", "Transparent objects block the light wholly.", topic,
     [](Laws& laws) {
         laws.shadow = [](const Place& place, const Step& step, const Shine& shine) {
             return wanted(place) ? stopped_by(between(place, step.point, shine.towards,
                                                       step.surface, shine.distance, any_hit))
                                  : Passage{};
         };
     }},
    {"shd.tint_once",
     "Light through glass is tinted once, not at every crossing.",
     topic,
     [](Laws& laws) {
         laws.shadow = [](const Place& place, const Step& step, const Shine& shine) {
             Passage passage = model::shadow(place, step, shine);
             if (place.scene().settings.shadows == ShadowMode::transmissive) {
                 const auto hits = between(place, step.point, shine.towards, step.surface,
                                           shine.distance, any_hit);
                 if (!hits.empty()) {
                     passage.transmittance = material_of(place, hits.front().primitive).kt;
                 }
             }
             return passage;
         };
     },
     {[](Laws& laws) {  // what is opaque blocks it all the same
         laws.shadow = [](const Place& place, const Step& step, const Shine& shine) {
             Passage passage = model::shadow(place, step, shine);
             const auto hits =
                 between(place, step.point, shine.towards, step.surface, shine.distance, any_hit);
             if (!is_zero(passage.transmittance) && !hits.empty()) {
                 passage.transmittance = material_of(place, hits.front().primitive).kt;
             }
             return passage;
         };
     }}},
    {"shd.first_hit_only_then_compare",
     "One hit alone is compared with the light's distance, whatever else lies in between.",
     topic,
     [](Laws& laws) { laws.shadow = first_of_the_list; },
     {[](Laws& laws) { laws.shadow = nearest_alone; }}},
    {"shd.only_first_light", "Only the first light casts shadows.", topic,
     [](Laws& laws) {
         laws.shadow = [](const Place& place, const Step& step, const Shine& shine) {
             return shine.light == 0 ? model::shadow(place, step, shine) : Passage{};
         };
     }},
    {"shd.directional_none", "Directional lights cast no shadows.", topic,
     [](Laws& laws) {
         laws.shadow = [](const Place& place, const Step& step, const Shine& shine) {
             return shine.ready->directional ? Passage{} : model::shadow(place, step, shine);
         };
     }},
    {"shd.spec_not_shadowed", "The highlight is not shadowed, only diffuse light.", topic,
     [](Laws& laws) {
         laws.specular = [](const Place& place, const Step& step, const Shine& shine) {
             Shine lit = shine;
             lit.transmittance = Spectrum(1.0);
             return model::specular(place, step, lit);
         };
     }},
    {"shd.diffuse_not_shadowed", "Diffuse light is not shadowed, only the highlight.", topic,
     [](Laws& laws) {
         laws.diffuse = [](const Place& place, const Step& step, const Shine& shine) {
             Shine lit = shine;
             lit.transmittance = Spectrum(1.0);
             return model::diffuse(place, step, lit);
         };
     }},
    {"shd.half_dark", "A blocked light still gives half of its light.", topic,
     [](Laws& laws) {
         laws.shadow = [](const Place& place, const Step& step, const Shine& shine) {
             Passage passage = model::shadow(place, step, shine);
             if (is_zero(passage.transmittance)) {
                 passage.transmittance = Spectrum(0.5);
             }
             return passage;
         };
     }},
    {"shd.kills_ambient", "In shadow the ambient light is lost as well.", topic,
     [](Laws& laws) {
         laws.combine = [](const Place& place, const Step& step, const Terms& terms) {
             Terms dark = terms;
             if (is_zero(terms.diffuse) && is_zero(terms.specular)) {
                 dark.ambient = Spectrum(0.0);
             }
             return model::combine(place, step, dark);
         };
     }},
};

}  // namespace

std::span<const MistakeRow> shadow_mistakes() { return rows; }

}  // namespace raytree::check
