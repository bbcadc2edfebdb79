#include <cmath>
#include <limits>
#include <utility>

#include "check/catalogue.h"
#include "check/shape_by_shape.h"

namespace raytree::check {
namespace {

constexpr std::string_view topic = "intersection";
constexpr double at_the_start = 1e-6;  // of the scene's size: where a ray meets its own start

/// What a sphere's quadratic equation is made of, in its own space.
struct Quadratic {
    double a = 1, b = 0, c = 0;
    double far = 0;  ///< |f|, to tell what is near 0
    double radius = 1;
    Ray<double> own;

    double discriminant() const { return b * b - 4 * a * c; }
};

const Object& object_at(const Place& place, PrimitiveId id) {
    return place.scene().objects[place.shapes.shapes()[id].object];
}

/// The ray in the shape's own space.
Ray<double> own_ray(const Place& place, const Step& step, PrimitiveId id) {
    const Object& object = object_at(place, id);
    const Ray<double> ray = ray_of(step);
    return object.transform ? AffineMap<double>(*object.transform).ray_to_own_space(ray) : ray;
}

const Sphere* sphere_of(const Place& place, PrimitiveId id) {
    return std::get_if<Sphere>(&object_at(place, id).shape);
}

/// Whether the ray starts where the shape was hit, though the point may lie beside the true shape.
bool starts_on(const Step& step, PrimitiveId id) {
    const Step* const from = step.kind == RayKind::shadow ? &step : step.parent;
    return step.leaving == id || (from && from->primitive == id);
}

/// The two solutions that `formula` gives for spheres; other shapes are met rightly.
template <auto formula> OwnRoots solved(const Place& place, const Step& step, PrimitiveId id) {
    const Sphere* const sphere = sphere_of(place, id);
    if (!sphere) {
        return std::nullopt;
    }
    const Ray<double> own = own_ray(place, step, id);
    const Vec f = own.origin - sphere->center;
    const Quadratic q{inner(own.direction, own.direction),
                      2 * inner(f, own.direction),
                      inner(f, f) - sphere->radius * sphere->radius,
                      length(f),
                      sphere->radius,
                      own};
    const auto [first, second] = formula(q);
    Roots2 roots;
    for (const double t : {std::min(first, second), std::max(first, second)}) {
        const bool own_start = starts_on(step, id) && t <= at_the_start * (q.far + q.radius);
        if (std::isfinite(t) && !own_start) {
            roots.add(t);
        }
    }
    return roots;
}

using Two = std::pair<double, double>;

/// (-b - root) / (2 a) and (-b + root) / (2 a).
Two halves(double a, double b, double root) {
    return {(-b - root) / (2 * a), (-b + root) / (2 * a)};
}

Two missing_paren(const Quadratic& q) {
    const double root = std::sqrt(q.discriminant());
    return {(-q.b - root) / 2 * q.a, (-q.b + root) / 2 * q.a};
}
Two b_not_doubled(const Quadratic& q) {
    return halves(q.a, q.b / 2, std::sqrt(q.b * q.b / 4 - 4 * q.a * q.c));
}
Two disc_no4(const Quadratic& q) { return halves(q.a, q.b, std::sqrt(q.b * q.b - q.a * q.c)); }
Two no_sqrt(const Quadratic& q) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    const double disc = q.discriminant();
    return disc >= 0 ? halves(q.a, q.b, disc) : Two{none, none};
}
Two not_halved(const Quadratic& q) { return halves(q.a / 2, q.b, std::sqrt(q.discriminant())); }
Two b_sign(const Quadratic& q) { return halves(q.a, -q.b, std::sqrt(q.discriminant())); }
Two with_c(const Quadratic& q, double c) {
    return halves(q.a, q.b, std::sqrt(q.b * q.b - 4 * q.a * c));
}
Two radius_not_squared(const Quadratic& q) {
    return with_c(q, q.c + q.radius * q.radius - q.radius);
}
Two w_in_dot(const Quadratic& q) { return with_c(q, q.c + 1); }
Two centre_ignored(const Quadratic& q) {
    Quadratic other = q;
    other.b = 2 * inner(q.own.origin, q.own.direction);
    return with_c(other, inner(q.own.origin, q.own.origin) - q.radius * q.radius);
}

/// Whether the start lies inside or on the sphere, so that its nearer root is not ahead.
bool starts_within(const Place& place, const Step& step, PrimitiveId id) {
    const Sphere* const sphere = sphere_of(place, id);
    return sphere && length(own_ray(place, step, id).origin - sphere->center) <=
                         sphere->radius * (1 + at_the_start);
}

OwnRoots near_only(const Place& place, const Step& step, PrimitiveId id) {
    if (is_planar(place, id)) {
        return std::nullopt;
    }
    const Roots2 roots = roots_of(place, step, id);
    Roots2 first;
    if (roots.count > 0 && !starts_within(place, step, id)) {
        first.add(roots.t[0]);
    }
    return first;
}

OwnRoots far_root(const Place& place, const Step& step, PrimitiveId id) {
    if (is_planar(place, id)) {
        return std::nullopt;
    }
    const Roots2 roots = roots_of(place, step, id);
    Roots2 last;
    if (roots.count > 0) {
        last.add(roots.t[static_cast<std::size_t>(roots.count - 1)]);
    }
    return last;
}

OwnRoots own_units(const Place& place, const Step& step, PrimitiveId id) {
    if (!object_at(place, id).transform) {
        return std::nullopt;
    }
    Roots2 roots = roots_of(place, step, id);
    if (roots.count == 0) {
        return roots;
    }
    const double size = length(own_ray(place, step, id).direction);
    for (double& t : roots.t) {
        t *= size;
    }
    return roots;
}

/// The world's direction that, taken rightly to the object's space, is what a direction moved
/// like a point is there: d - T, as M^-1 (d - T) + ... is linear in both.
Ray<double> moved_ray(const Object& object, const Step& step) {
    Ray<double> ray = ray_of(step);
    if (object.transform) {
        const Affine& m = *object.transform;
        ray.direction -= Vec(m[0][3], m[1][3], m[2][3]);
    }
    return ray;
}

OwnRoots moved_direction(const Place& place, const Step& step, PrimitiveId id) {
    if (!object_at(place, id).transform) {
        return std::nullopt;
    }
    return place.shapes.shapes().intersect(id, moved_ray(object_at(place, id), step), step.leaving);
}

/// The normal where the object's own ray meets it.
Turned normal_of_moved(const Place& place, const Step& step) {
    const Ray<double> ray = moved_ray(object_at(place, step.primitive), step);
    const auto surface = place.shapes.shapes().surface_at(step.primitive, ray, step.t);
    const bool front = inner(step.direction, surface.geometric_normal.vec()) < 0;
    return {front ? surface.shading_normal.vec() : -surface.shading_normal.vec(), front};
}

const MistakeRow rows[] = {
    {"isect.missing_paren",
     "(-b - root) / 2 * a is written for (-b - root) / (2 a).",
     topic,
     everywhere<solved<missing_paren>>,
     {but_for_shadows<solved<missing_paren>>}},
    {"isect.b_not_doubled",
     "b = f . d is used in the formula with 4ac, which wants 2 f . d.",
     topic,
     everywhere<solved<b_not_doubled>>,
     {but_for_shadows<solved<b_not_doubled>>}},
    {"isect.disc_no4",
     "The discriminant is b^2 - ac instead of b^2 - 4ac.",
     topic,
     everywhere<solved<disc_no4>>,
     {but_for_shadows<solved<disc_no4>>}},
    {"isect.no_sqrt",
     "The discriminant's square root is not taken.",
     topic,
     everywhere<solved<no_sqrt>>,
     {but_for_shadows<solved<no_sqrt>>}},
    {"isect.not_halved",
     "The roots are not divided by 2.",
     topic,
     everywhere<solved<not_halved>>,
     {but_for_shadows<solved<not_halved>>}},
    {"isect.b_sign",
     "The sign of b is wrong in the solution: b - root instead of -b - root.",
     topic,
     everywhere<solved<b_sign>>,
     {but_for_shadows<solved<b_sign>>}},
    {"isect.radius_not_squared",
     "The radius is not squared in c.",
     topic,
     everywhere<solved<radius_not_squared>>,
     {but_for_shadows<solved<radius_not_squared>>}},
    {"isect.w_in_dot",
     "The fourth component takes part in the dot product: c is off by 1.",
     topic,
     everywhere<solved<w_in_dot>>,
     {but_for_shadows<solved<w_in_dot>>}},
    {"isect.centre_ignored",
     "The sphere's centre is not taken from the ray's origin.",
     topic,
     everywhere<solved<centre_ignored>>,
     {but_for_shadows<solved<centre_ignored>>}},
    {"isect.far_root",
     "The farther root is taken.",
     topic,
     everywhere<far_root>,
     {but_for_shadows<far_root>}},
    {"isect.near_only",
     "Only the smaller root is tried: from inside, a sphere is missed.",
     topic,
     everywhere<near_only>,
     {but_for_shadows<near_only>}},
    {"isect.local_dir_normalised",
     "The direction is made unit in the object's own space, so that t has other units.",
     topic,
     everywhere<own_units>,
     {but_for_shadows<own_units>}},
    {"isect.translation_on_dir",
     "The direction is moved like a point on the way to the object's own space: its w is 1.",
     topic,
     [](Laws& laws) {
         everywhere<moved_direction>(laws);
         laws.normal = normal_of_moved;
     },
     {everywhere<moved_direction>}},
};

}  // namespace

std::span<const MistakeRow> sphere_mistakes() { return rows; }

}  // namespace raytree::check
