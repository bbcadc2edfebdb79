#include <algorithm>
#include <cmath>

#include "check/catalogue.h"
#include "check/shape_by_shape.h"

namespace raytree::check {
namespace {

constexpr std::string_view topic = "intersection";

bool is_planar(const Place& place, PrimitiveId id) {
    const ShapeKind kind = place.shapes.shapes()[id].kind;
    return kind == ShapeKind::polygon || kind == ShapeKind::triangle;
}

Step backwards(const Step& step) {
    Step back = step;
    back.direction = -step.direction;
    return back;
}

Roots2 plane_sign(const Place& place, const Step& step, PrimitiveId id) {
    return roots_of(place, is_planar(place, id) ? backwards(step) : step, id);
}

/// The lowest root, whatever its sign.
Roots2 negative_t(const Place& place, const Step& step, PrimitiveId id) {
    const Roots2 behind = roots_of(place, backwards(step), id);
    if (behind.count == 0) {
        return roots_of(place, step, id);
    }
    Roots2 roots;
    roots.count = 1;
    roots.t[0] = -behind.t[static_cast<std::size_t>(behind.count - 1)];
    return roots;
}

template <bool planar_only> Roots2 culled(const Place& place, const Step& step, PrimitiveId id) {
    const Roots2 roots = roots_of(place, step, id);
    Roots2 kept;
    for (int n = 0; n < roots.count; ++n) {
        const double t = roots.t[static_cast<std::size_t>(n)];
        const Vec normal = place.shapes.shapes().surface_at(id, ray_of(step), t).geometric_normal;
        if ((planar_only && !is_planar(place, id)) || inner(step.direction, normal) < 0) {
            kept.add(t);
        }
    }
    return kept;
}

template <class Better>
Found preferring(const Place& place, const Step& step, Interval<double> interval, Better better) {
    return choose(place, step, interval, roots_of, better);
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
        [](const Place& of, const Step& by, PrimitiveId id) {
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

Interval<double> from_at_least(const Place& place, const Step& step, double least) {
    Interval<double> interval = model::interval(place, step);
    interval.from = std::max(interval.from, least);
    return interval;
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
    {"isect.t_int", "t is cut off to a whole number.", topic,
     [](Laws& laws) { laws.meet = whole_number; }},
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
    {"eps.too_large", "What is nearer than a large epsilon (0.25) is overlooked.", topic,
     [](Laws& laws) {
         laws.interval = [](const Place& place, const Step& step) {
             return from_at_least(place, step, step.kind == RayKind::primary ? 0 : 0.25);
         };
     }},
    {"hit.near_rule_on_secondary", "The near distance is applied to all rays.", topic,
     [](Laws& laws) {
         laws.interval = [](const Place& place, const Step& step) {
             return from_at_least(place, step, place.scene().camera.near);
         };
     }},
    {"hit.beyond_image_plane", "Only hits with t > 1 count, for secondary rays too.", topic,
     [](Laws& laws) {
         laws.interval = [](const Place& place, const Step& step) {
             return from_at_least(place, step, 1);
         };
     }},
    {"hit.primary_without_near", "The near distance is ignored.", topic,
     [](Laws& laws) {
         laws.interval = [](const Place& place, const Step& step) {
             Interval<double> interval = model::interval(place, step);
             interval.from = 0;
             return interval;
         };
     }},
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
