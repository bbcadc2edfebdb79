#include <algorithm>
#include <cmath>

#include "check/catalogue.h"
#include "check/shape_by_shape.h"

namespace raytree::check {
namespace {

constexpr std::string_view topic = "intersection";

/// The model's roots of one shape behind the ray's start.
Roots2 roots_behind(const Place& place, const Step& step, PrimitiveId id) {
    const Ray<double> back{step.origin, -step.direction, model::origin_error(step.origin)};
    return place.shapes.shapes().intersect(id, back, step.leaving);
}

OwnRoots plane_sign(const Place& place, const Step& step, PrimitiveId id) {
    return is_planar(place, id) ? OwnRoots(roots_behind(place, step, id)) : std::nullopt;
}

/// The lowest root, whatever its sign.
OwnRoots negative_t(const Place& place, const Step& step, PrimitiveId id) {
    const Roots2 behind = roots_behind(place, step, id);
    if (behind.count == 0) {
        return std::nullopt;
    }
    Roots2 roots;
    roots.count = 1;
    roots.t[0] = -behind.t[static_cast<std::size_t>(behind.count - 1)];
    return roots;
}

template <bool planar_only> OwnRoots culled(const Place& place, const Step& step, PrimitiveId id) {
    if (planar_only && !is_planar(place, id)) {
        return std::nullopt;
    }
    const Roots2 roots = roots_of(place, step, id);
    Roots2 kept;
    for (int n = 0; n < roots.count; ++n) {
        const double t = roots.t[static_cast<std::size_t>(n)];
        const Vec normal = place.shapes.shapes().surface_at(id, ray_of(step), t).geometric_normal;
        if (inner(step.direction, normal) < 0) {
            kept.add(t);
        }
    }
    return kept;
}

template <class Better>
Found preferring(const Place& place, const Step& step, Interval<double> interval, Better better) {
    return choose(place, step, interval, as_the_model, better);
}

/// The order of objects decides and not the distance; of one object, the nearer root.
Found last_wins(const Place& place, const Step& step, Interval<double> interval) {
    return preferring(place, step, interval, [](const Hit<double>& a, const Hit<double>& b) {
        return a.primitive != b.primitive ? a.primitive > b.primitive : a.t < b.t;
    });
}
Found first_wins(const Place& place, const Step& step, Interval<double> interval) {
    return preferring(place, step, interval, [](const Hit<double>& a, const Hit<double>& b) {
        return a.primitive != b.primitive ? a.primitive < b.primitive : a.t < b.t;
    });
}
Found farthest(const Place& place, const Step& step, Interval<double> interval) {
    return choose(
        place, step, interval,
        [](const Place& of, const Step& by, PrimitiveId id) -> OwnRoots {
            Roots2 roots = roots_of(of, by, id);
            roots.count = std::min(roots.count, 1);
            return roots;
        },
        [](const Hit<double>& a, const Hit<double>& b) { return a.t > b.t; });
}

Found whole_number(const Place& place, const Step& step, Interval<double> interval) {
    Found hit = model::meet(place, step, interval);
    if (hit) {
        hit->t = std::trunc(hit->t);
    }
    return hit;
}

/// As a program has it that knows which surface a ray leaves, be its start beside it.
void whole_number_by_surface(Laws& laws) {
    laws.meet = [](const Place& place, const Step& step, Interval<double> interval) {
        Step from = step;
        from.leaving = step.parent ? step.parent->primitive : no_primitive;
        return whole_number(place, from, interval);
    };
    laws.shadow = [](const Place& place, const Step& step, const Shine& shine) {
        Step from = step;
        from.surface = step.primitive;
        return model::shadow(place, from, shine);
    };
}

Interval<double> from_at_least(const Place& place, const Step& step, double least) {
    Interval<double> interval = model::interval(place, step);
    interval.from = std::max(interval.from, least);
    return interval;
}

Interval<double> near_not_asked(const Place& place, const Step& step) {
    Interval<double> interval = model::interval(place, step);
    interval.from = 0;
    return interval;
}

template <int hundredths> Interval<double> beyond_epsilon(const Place& place, const Step& step) {
    return from_at_least(place, step, step.kind == RayKind::primary ? 0 : hundredths / 100.0);
}

/// What stands between a hit and a light, but for what is nearer to the hit than `least`.
Passage shadow_beyond(const Place& place, const Step& step, const Shine& shine, double least) {
    if (place.scene().settings.shadows == ShadowMode::none) {
        return {};
    }
    NoTestCount none;
    const Ray<double> ray{step.point, shine.towards, model::origin_error(step.point)};
    const Interval<double> between{least, shine.distance * (1 - 8 * Real<double>::unit_roundoff)};
    return between.from < between.to
               ? model::through(place, place.shapes.all(ray, step.surface, between, none))
               : Passage{};
}

template <int hundredths> void overlooks(Laws& laws) {
    laws.interval = beyond_epsilon<hundredths>;
    laws.shadow = [](const Place& place, const Step& step, const Shine& shine) {
        return shadow_beyond(place, step, shine, hundredths / 100.0);
    };
}

Interval<double> beyond_near(const Place& place, const Step& step) {
    return from_at_least(place, step, place.scene().camera.near);
}

void beyond_the_plane(Laws& laws) {
    laws.interval = [](const Place& place, const Step& step) {
        return from_at_least(place, step, 1);
    };
}

void beyond_the_plane_and_shadows(Laws& laws) {
    beyond_the_plane(laws);
    laws.shadow = [](const Place& place, const Step& step, const Shine& shine) {
        return shadow_beyond(place, step, shine, 1);
    };
}

const MistakeRow rows[] = {
    {"isect.negative_t",
     "Hits behind the ray's start are accepted: there is no test for t > 0.",
     topic,
     but_for_shadows<negative_t, true>,
     {everywhere<negative_t, true>}},
    {"isect.last_wins", "The last object in the list wins and not the nearest.", topic,
     [](Laws& laws) { laws.meet = last_wins; }},
    {"isect.first_wins", "The first object in the list wins and not the nearest.", topic,
     [](Laws& laws) { laws.meet = first_wins; }},
    {"isect.farthest", "The farthest object wins: the comparison is the wrong way round.", topic,
     [](Laws& laws) { laws.meet = farthest; }},
    {"isect.plane_sign",
     "The sign of t is wrong for planes.",
     topic,
     everywhere<plane_sign>,
     {but_for_shadows<plane_sign>}},
    {"isect.t_int",
     "t is cut off to a whole number.",
     topic,
     [](Laws& laws) { laws.meet = whole_number; },
     {whole_number_by_surface}},
    {"isect.backface_culled",
     "Back sides are not hit at all.",
     topic,
     everywhere<culled<false>>,
     {but_for_shadows<culled<false>>}},
    {"isect.polygon_one_sided",
     "Polygons are hit from the front only.",
     topic,
     everywhere<culled<true>>,
     {but_for_shadows<culled<true>>}},
    {"eps.too_large",
     "What is nearer than a large epsilon (0.25, say) is overlooked.",
     topic,
     [](Laws& laws) { laws.interval = beyond_epsilon<25>; },
     {overlooks<25>, overlooks<10>, overlooks<50>, overlooks<1>}},
    {"hit.near_rule_on_secondary",
     "The near distance, or that of the image plane, is applied to all rays.",
     topic,
     [](Laws& laws) { laws.interval = beyond_near; },
     {[](Laws& laws) {
          laws.interval = beyond_near;
          laws.shadow = [](const Place& place, const Step& step, const Shine& shine) {
              return shadow_beyond(place, step, shine, place.scene().camera.near);
          };
      },
      beyond_the_plane, beyond_the_plane_and_shadows}},
    {"hit.primary_without_near", "The near distance is ignored.", topic,
     [](Laws& laws) { laws.interval = near_not_asked; }},
    {"isect.bool_precedence",
     "A condition as a && b || c lacks its parentheses: the near distance is not asked.", topic,
     [](Laws& laws) { laws.interval = near_not_asked; }},
    {"hit.point_no_origin", "The hit point is t d: the origin is not added.", topic,
     [](Laws& laws) {
         laws.point = [](const Place&, const Step& step, const Vec&) {
             return step.t * step.direction;
         };
     }},
    {"hit.point_minus", "The hit point is o - t d.", topic,
     [](Laws& laws) {
         laws.point = [](const Place&, const Step& step, const Vec&) {
             return along(step.origin, -step.t, step.direction);
         };
     }},
    {"hit.point_from_eye", "The hit point is counted from the eye for every ray.", topic,
     [](Laws& laws) {
         laws.point = [](const Place& place, const Step& step, const Vec&) {
             return along(place.scene().camera.eye, step.t, step.direction);
         };
     }},
    {"hit.t_units_mixed", "t is measured along one direction and used along another length of it.",
     topic,
     [](Laws& laws) {
         laws.point = [](const Place& place, const Step& step, const Vec& on_surface) {
             const double share = inner(step.direction, place.camera.forward().vec());
             return step.kind == RayKind::primary
                        ? along(step.origin, step.t * share, step.direction)
                        : on_surface;
         };
     }},
};

}  // namespace

std::span<const MistakeRow> hit_mistakes() { return rows; }

}  // namespace raytree::check
