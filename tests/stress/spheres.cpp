#include "geometry/sphere_error.h"
#include "stress.h"

namespace raytree::stress {
namespace {

struct Trial {
    SphereShape<double> sphere;
    Ray<double> ray;
};

/// Distances of 1 to 10^12 radii; the sphere's size and place are of any order of magnitude.
Trial trial(Random& random) {
    Trial result;
    const double radius = random.log_uniform(1e-6, 1e6);
    const double distance = radius * random.log_uniform(1, 1e12);
    const double offset = random.chance(0.5) ? 0 : radius * random.log_uniform(1e-3, 1e8);
    const Vec3<double> view = random.direction();
    result.sphere = {offset * random.in_cube(), radius};
    result.ray.origin = result.sphere.center + distance * view;
    const Vec3<double> aim =
        result.sphere.center + radius * random.uniform(0, 1.2) * random.across(view).vec();
    result.ray.direction = UnitVec3<double>::of(aim - result.ray.origin);
    return result;
}

/// The componentwise condition number of a root: how far t moves, relatively, when every number of
/// the ray and of the sphere does (Higham 2002, sec. 1.6), by dt/do = -n / (n.d) and the like.
template <class T> double condition(const SphereShape<T>& sphere, const Ray<T>& ray, T t) {
    const Vec3<T> normal = along(Vec3<T>(ray.origin - sphere.center), t, ray.direction);
    T moves = sphere.radius * sphere.radius;  // everything is multiplied by the radius
    for (int k = 0; k < 3; ++k) {
        moves += abs(normal[k]) *
                 (abs(ray.origin[k]) + abs(sphere.center[k]) + abs(t * ray.direction[k]));
    }
    return static_cast<double>(moves / abs(t * inner(normal, ray.direction)));
}

template <class To> Ray<To> cast(const Ray<double>& ray) {
    return {vector_cast<To>(ray.origin), vector_cast<To>(ray.direction), To(0)};
}

/// Whether a missing or an additional root is within the bound: the line touches the sphere within
/// it, or the root is at the ray's start within it.
template <class Ref, class T> bool within_bound(const SphereShape<Ref>& sphere, const Ray<Ref>& ray,
                                                const SphereApproach<T>& bound) {
    const SphereApproach<Ref> at = approach(sphere, ray);
    if (abs(at.square) <= Ref(bound.error)) {
        return true;
    }
    const Ref off_surface = abs(at.away - sphere.radius) / sphere.radius;
    return off_surface <= Ref(bound.error);
}

template <class T> void try_one(const Trial& trial, Tally& tally) {
    using Ref = Reference<T>;
    const SphereShape<T> sphere{vector_cast<T>(trial.sphere.center),
                                static_cast<T>(trial.sphere.radius)};
    const Ray<T> ray = cast<T>(trial.ray);
    const SphereShape<Ref> exact_sphere{vector_cast<Ref>(sphere.center),
                                        static_cast<Ref>(sphere.radius)};
    const Ray<Ref> exact_ray{vector_cast<Ref>(ray.origin), vector_cast<Ref>(ray.direction), Ref(0)};
    const Roots<T> found = intersect(sphere, ray, Start::anywhere);
    const Roots<Ref> exact = intersect(exact_sphere, exact_ray, Start::anywhere);
    Outcome& outcome = tally.in<T>();
    const auto describe = [&](std::ostream& out) {
        out << "sphere at " << trial.sphere.center << " of radius " << trial.sphere.radius
            << ", ray from " << trial.ray.origin << " along " << trial.ray.direction << ": "
            << found.count << " roots, exactly " << exact.count;
    };
    if (found.count != exact.count) {
        if (within_bound(exact_sphere, exact_ray, approach(sphere, ray))) {
            ++outcome.undecided;
        } else {
            ++outcome.wrong;
            tally.describe<T>(describe);
        }
        return;
    }
    for (std::size_t k = 0; k < static_cast<std::size_t>(exact.count); ++k) {
        const Ref t = exact.t[k];
        const auto error = static_cast<double>(abs((Ref(found.t[k]) - t) / t));
        const double allowed =
            8 * static_cast<double>(Real<T>::unit_roundoff) * condition(exact_sphere, exact_ray, t);
        if (!outcome.judge(error / allowed)) {
            tally.describe<T>(describe);
        }
    }
}

Tally run(Random& random, std::uint64_t trials) {
    Tally tally;
    for (; tally.trials < trials; ++tally.trials) {
        const Trial one = trial(random);
        try_one<double>(one, tally);
        try_one<float>(one, tally);
    }
    return tally;
}

}  // namespace

Row spheres() {
    return {"spheres",
            "spheres seen from 1 to 10^12 radii away, of radius 10^-6 to 10^6",
            "rays",
            "`t` within 4 ulp times its condition number; no root lost or won beyond the bound",
            "4 ulp times the condition number",
            20'000,
            100'000'000,
            10'000,
            run};
}

}  // namespace raytree::stress
