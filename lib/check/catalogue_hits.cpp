#include <algorithm>
#include <cmath>

#include "check/catalogue.h"

namespace raytree::check {
namespace {

constexpr std::string_view topic = "intersection";
constexpr std::size_t most_shapes = 600;  // beyond which shapes are not tried one by one
constexpr double at_the_start = 1e-6;     // of the scene's size: where a ray meets its own start

using Found = std::optional<Hit<double>>;
using Roots2 = Roots<double>;

Ray<double> ray_of(const Step& step) {
    return {step.origin, step.direction, model::origin_error(step.origin)};
}

bool inside(double t, const Interval<double>& interval) {
    return t >= interval.from && t < interval.to;
}

/// The hit that `better(new, old)` prefers, of all that `roots(shape)` gives.
template <class RootsOf, class Better> Found choose(const Place& place, const Step& step,
                                                    Interval<double> interval, RootsOf roots_of,
                                                    Better better, bool behind = false) {
    const auto& shapes = place.shapes.shapes();
    if (shapes.size() > most_shapes) {
        return model::meet(place, step, interval);
    }
    Found best;
    for (std::size_t k = 0; k < shapes.size(); ++k) {
        const auto id = static_cast<PrimitiveId>(k);
        const Roots2 roots = roots_of(id);
        for (int n = 0; n < roots.count; ++n) {
            const Hit<double> hit{roots.t[static_cast<std::size_t>(n)], id};
            if ((behind || inside(hit.t, interval)) && (!best || better(hit, *best))) {
                best = hit;
            }
        }
    }
    return best;
}

bool nearer(const Hit<double>& a, const Hit<double>& b) { return a < b; }

Roots2 roots_of(const Place& place, const Step& step, PrimitiveId id) {
    return place.shapes.shapes().intersect(id, ray_of(step), step.leaving);
}

/// What a sphere's quadratic equation is made of, in its own space.
struct Quadratic {
    double a = 1, b = 0, c = 0;
    double far = 0;  ///< |f|, to tell what is near 0
};

/// Nearest hit where spheres are met by a formula of the student's.
template <class Formula>
Found spheres_by(const Place& place, const Step& step, Interval<double> interval, Formula formula) {
    const auto& shapes = place.shapes.shapes();
    return choose(
        place, step, interval,
        [&](PrimitiveId id) {
            const Primitive& primitive = shapes[id];
            const Object& object = place.scene().objects[primitive.object];
            const auto* sphere = std::get_if<Sphere>(&object.shape);
            if (!sphere) {
                return roots_of(place, step, id);
            }
            Ray<double> own = ray_of(step);
            if (object.transform) {
                own = AffineMap<double>(*object.transform).ray_to_own_space(own);
            }
            const Vec f = own.origin - sphere->center;
            const Quadratic q{inner(own.direction, own.direction), 2 * inner(f, own.direction),
                              inner(f, f) - sphere->radius * sphere->radius, length(f)};
            Roots2 all;
            formula(q, *sphere, own, all);
            Roots2 kept;
            for (int n = 0; n < all.count; ++n) {
                const double t = all.t[static_cast<std::size_t>(n)];
                if (step.leaving != id || t > at_the_start * (q.far + sphere->radius)) {
                    kept.add(t);
                }
            }
            return kept;
        },
        nearer);
}

void add_both(Roots2& roots, double a, double b) {
    if (std::isfinite(a) && std::isfinite(b)) {
        roots.add(std::min(a, b));
        roots.add(std::max(a, b));
    }
}

Found missing_paren(const Place& place, const Step& step, Interval<double> interval) {
    return spheres_by(place, step, interval,
                      [](const Quadratic& q, const Sphere&, const Ray<double>&, Roots2& roots) {
                          const double root = std::sqrt(q.b * q.b - 4 * q.a * q.c);
                          add_both(roots, (-q.b - root) / 2 * q.a, (-q.b + root) / 2 * q.a);
                      });
}
Found b_not_doubled(const Place& place, const Step& step, Interval<double> interval) {
    return spheres_by(place, step, interval,
                      [](const Quadratic& q, const Sphere&, const Ray<double>&, Roots2& roots) {
                          const double b = q.b / 2;
                          const double root = std::sqrt(b * b - 4 * q.a * q.c);
                          add_both(roots, (-b - root) / (2 * q.a), (-b + root) / (2 * q.a));
                      });
}
Found disc_no4(const Place& place, const Step& step, Interval<double> interval) {
    return spheres_by(place, step, interval,
                      [](const Quadratic& q, const Sphere&, const Ray<double>&, Roots2& roots) {
                          const double root = std::sqrt(q.b * q.b - q.a * q.c);
                          add_both(roots, (-q.b - root) / (2 * q.a), (-q.b + root) / (2 * q.a));
                      });
}
Found no_sqrt(const Place& place, const Step& step, Interval<double> interval) {
    return spheres_by(place, step, interval,
                      [](const Quadratic& q, const Sphere&, const Ray<double>&, Roots2& roots) {
                          const double disc = q.b * q.b - 4 * q.a * q.c;
                          if (disc >= 0) {
                              add_both(roots, (-q.b - disc) / (2 * q.a), (-q.b + disc) / (2 * q.a));
                          }
                      });
}
Found not_halved(const Place& place, const Step& step, Interval<double> interval) {
    return spheres_by(place, step, interval,
                      [](const Quadratic& q, const Sphere&, const Ray<double>&, Roots2& roots) {
                          const double root = std::sqrt(q.b * q.b - 4 * q.a * q.c);
                          add_both(roots, (-q.b - root) / q.a, (-q.b + root) / q.a);
                      });
}
Found b_sign(const Place& place, const Step& step, Interval<double> interval) {
    return spheres_by(place, step, interval,
                      [](const Quadratic& q, const Sphere&, const Ray<double>&, Roots2& roots) {
                          const double root = std::sqrt(q.b * q.b - 4 * q.a * q.c);
                          add_both(roots, (q.b - root) / (2 * q.a), (q.b + root) / (2 * q.a));
                      });
}
Found radius_not_squared(const Place& place, const Step& step, Interval<double> interval) {
    return spheres_by(
        place, step, interval,
        [](const Quadratic& q, const Sphere& sphere, const Ray<double>&, Roots2& roots) {
            const double c = q.c + sphere.radius * sphere.radius - sphere.radius;
            const double root = std::sqrt(q.b * q.b - 4 * q.a * c);
            add_both(roots, (-q.b - root) / (2 * q.a), (-q.b + root) / (2 * q.a));
        });
}
Found centre_ignored(const Place& place, const Step& step, Interval<double> interval) {
    return spheres_by(
        place, step, interval,
        [](const Quadratic& q, const Sphere& sphere, const Ray<double>& own, Roots2& roots) {
            const double b = 2 * inner(own.origin, own.direction);
            const double c = inner(own.origin, own.origin) - sphere.radius * sphere.radius;
            const double root = std::sqrt(b * b - 4 * q.a * c);
            add_both(roots, (-b - root) / (2 * q.a), (-b + root) / (2 * q.a));
        });
}

/// With the roots of each shape changed.
template <class Change>
Found with_roots(const Place& place, const Step& step, Interval<double> interval, Change change) {
    return choose(
        place, step, interval,
        [&](PrimitiveId id) { return change(id, roots_of(place, step, id)); }, nearer);
}

Found far_root(const Place& place, const Step& step, Interval<double> interval) {
    return with_roots(place, step, interval, [](PrimitiveId, const Roots2& roots) {
        Roots2 last;
        if (roots.count > 0) {
            last.add(roots.t[static_cast<std::size_t>(roots.count - 1)]);
        }
        return last;
    });
}

/// Whether the start lies inside or on the sphere, so that its nearer root is not ahead.
bool starts_within(const Place& place, const Step& step, PrimitiveId id) {
    const Object& object = place.scene().objects[place.shapes.shapes()[id].object];
    const auto* sphere = std::get_if<Sphere>(&object.shape);
    if (!sphere) {
        return false;
    }
    Ray<double> own = ray_of(step);
    if (object.transform) {
        own = AffineMap<double>(*object.transform).ray_to_own_space(own);
    }
    return length(own.origin - sphere->center) <= sphere->radius * (1 + at_the_start);
}

Found near_only(const Place& place, const Step& step, Interval<double> interval) {
    return with_roots(place, step, interval, [&](PrimitiveId id, const Roots2& roots) {
        Roots2 first;
        if (roots.count > 0 && !starts_within(place, step, id)) {
            first.add(roots.t[0]);
        }
        return first;
    });
}

Found own_units(const Place& place, const Step& step, Interval<double> interval) {
    return with_roots(place, step, interval, [&](PrimitiveId id, Roots2 roots) {
        const Object& object = place.scene().objects[place.shapes.shapes()[id].object];
        if (object.transform) {
            const double size = length(
                AffineMap<double>(*object.transform).ray_to_own_space(ray_of(step)).direction);
            for (double& t : roots.t) {
                t *= size;
            }
        }
        return roots;
    });
}

Found plane_sign(const Place& place, const Step& step, Interval<double> interval) {
    Step back = step;
    back.direction = -step.direction;
    return choose(
        place, step, interval,
        [&](PrimitiveId id) {
            const ShapeKind kind = place.shapes.shapes()[id].kind;
            const bool planar = kind == ShapeKind::polygon || kind == ShapeKind::triangle;
            return roots_of(place, planar ? back : step, id);
        },
        nearer);
}

Found negative_t(const Place& place, const Step& step, Interval<double> interval) {
    Step back = step;
    back.direction = -step.direction;
    return choose(
        place, step, interval,
        [&](PrimitiveId id) {
            const Roots2 behind = roots_of(place, back, id);
            if (behind.count == 0) {
                return roots_of(place, step, id);
            }
            Roots2 roots;
            roots.count = 1;
            roots.t[0] = -behind.t[static_cast<std::size_t>(behind.count - 1)];
            return roots;
        },
        nearer, true);
}

Found culled(const Place& place, const Step& step, Interval<double> interval, bool planar_only) {
    return with_roots(place, step, interval, [&](PrimitiveId id, const Roots2& roots) {
        const ShapeKind kind = place.shapes.shapes()[id].kind;
        const bool planar = kind == ShapeKind::polygon || kind == ShapeKind::triangle;
        Roots2 kept;
        for (int n = 0; n < roots.count; ++n) {
            const double t = roots.t[static_cast<std::size_t>(n)];
            const Vec normal =
                place.shapes.shapes().surface_at(id, ray_of(step), t).geometric_normal;
            if ((planar_only && !planar) || inner(step.direction, normal) < 0) {
                kept.add(t);
            }
        }
        return kept;
    });
}

template <class Better>
Found preferring(const Place& place, const Step& step, Interval<double> interval, Better better) {
    return choose(
        place, step, interval, [&](PrimitiveId id) { return roots_of(place, step, id); }, better);
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
        [&](PrimitiveId id) {
            Roots2 roots = roots_of(place, step, id);
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
    {"isect.missing_paren", "(-b - root) / 2 * a is written for (-b - root) / (2 a).", topic,
     [](Laws& laws) { laws.meet = missing_paren; }},
    {"isect.b_not_doubled", "b = f . d is used in the formula with 4ac, which wants 2 f . d.",
     topic, [](Laws& laws) { laws.meet = b_not_doubled; }},
    {"isect.disc_no4", "The discriminant is b^2 - ac instead of b^2 - 4ac.", topic,
     [](Laws& laws) { laws.meet = disc_no4; }},
    {"isect.no_sqrt", "The discriminant's square root is not taken.", topic,
     [](Laws& laws) { laws.meet = no_sqrt; }},
    {"isect.not_halved", "The roots are not divided by 2.", topic,
     [](Laws& laws) { laws.meet = not_halved; }},
    {"isect.b_sign", "The sign of b is wrong in the solution: b - root instead of -b - root.",
     topic, [](Laws& laws) { laws.meet = b_sign; }},
    {"isect.radius_not_squared", "The radius is not squared in c.", topic,
     [](Laws& laws) { laws.meet = radius_not_squared; }},
    {"isect.centre_ignored", "The sphere's centre is not taken from the ray's origin.", topic,
     [](Laws& laws) { laws.meet = centre_ignored; }},
    {"isect.local_dir_normalised",
     "The direction is made unit in the object's own space, so that t has other units.", topic,
     [](Laws& laws) { laws.meet = own_units; }},
    {"isect.far_root", "The farther root is taken.", topic,
     [](Laws& laws) { laws.meet = far_root; }},
    {"isect.near_only", "Only the smaller root is tried: from inside, a sphere is missed.", topic,
     [](Laws& laws) { laws.meet = near_only; }},
    {"isect.negative_t", "Hits behind the ray's start are accepted: there is no test for t > 0.",
     topic, [](Laws& laws) { laws.meet = negative_t; }},
    {"isect.last_wins", "The last object in the list wins and not the nearest.", topic,
     [](Laws& laws) { laws.meet = last_wins; }},
    {"isect.first_wins", "The first object in the list wins and not the nearest.", topic,
     [](Laws& laws) { laws.meet = first_wins; }},
    {"isect.farthest", "The farthest object wins: the comparison is the wrong way round.", topic,
     [](Laws& laws) { laws.meet = farthest; }},
    {"isect.plane_sign", "The sign of t is wrong for planes.", topic,
     [](Laws& laws) { laws.meet = plane_sign; }},
    {"isect.t_int", "t is cut off to a whole number.", topic,
     [](Laws& laws) { laws.meet = whole_number; }},
    {"isect.backface_culled", "Back sides are not hit at all.", topic,
     [](Laws& laws) {
         laws.meet = [](const Place& place, const Step& step, Interval<double> interval) {
             return culled(place, step, interval, false);
         };
     }},
    {"isect.polygon_one_sided", "Polygons are hit from the front only.", topic,
     [](Laws& laws) {
         laws.meet = [](const Place& place, const Step& step, Interval<double> interval) {
             return culled(place, step, interval, true);
         };
     }},
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
