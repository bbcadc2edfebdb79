#include "geometry/sphere_error.h"
#include "stress.h"

namespace raytree::stress {
namespace {

template <class T> struct Trial {
    SphereShape<T> sphere;
    Ray<T> ray;
};

/// A ray whose line passes the sphere's rim within 1 to 10^6 units in the last place of the radius,
/// inside or outside, from 1 to 10^6 radii away.
template <class T> Trial<T> trial(Random& random) {
    using Ref = Reference<T>;
    Trial<T> result;
    const double radius = random.log_uniform(1e-3, 1e3);
    const double distance = radius * random.log_uniform(1.1, 1e6);
    const double offset = random.chance(0.5) ? 0 : radius * random.log_uniform(1e-3, 1e3);
    const Vec3<double> view = random.direction();
    const Vec3<double> center = offset * random.in_cube();
    const Vec3<double> aim = center + radius * random.across(view).vec();
    const Vec3<double> origin = center + distance * view;
    result.ray = {vector_cast<T>(origin), vector_cast<T>(UnitVec3<double>::of(aim - origin).vec()),
                  T(0)};
    result.sphere.center = vector_cast<T>(center);
    // The radius is what the line of the rounded ray leaves, and a little more or less.
    const SphereShape<Ref> about{vector_cast<Ref>(result.sphere.center), Ref(1)};
    const Ray<Ref> ray{vector_cast<Ref>(result.ray.origin), vector_cast<Ref>(result.ray.direction),
                       Ref(0)};
    const T rim = static_cast<T>(approach(about, ray).off_line);
    const double ulps = random.log_uniform(1, 1e6) * (random.chance(0.5) ? 1 : -1);
    result.sphere.radius = fma(static_cast<T>(ulps) * 2 * Real<T>::unit_roundoff, rim, rim);
    return result;
}

template <class T> void try_one(Random& random, Tally& tally) {
    using Ref = Reference<T>;
    const Trial<T> one = trial<T>(random);
    const SphereShape<Ref> sphere{vector_cast<Ref>(one.sphere.center), Ref(one.sphere.radius)};
    const Ray<Ref> ray{vector_cast<Ref>(one.ray.origin), vector_cast<Ref>(one.ray.direction),
                       Ref(0)};
    const SphereApproach<T> bound = approach(one.sphere, one.ray);
    const SphereApproach<Ref> exact = approach(sphere, ray);
    const Roots<T> found = intersect(one.sphere, one.ray, Start::anywhere);
    const Roots<Ref> roots = intersect(sphere, ray, Start::anywhere);
    Outcome& outcome = tally.in<T>();
    double share = 0;  // of what is allowed
    if (found.count != roots.count) {
        // How close it is to touching, as a share of the bound: over 1 is decided wrongly.
        share = static_cast<double>(abs(exact.square) / Ref(bound.error));
        outcome.undecided += share <= 1 ? 1 : 0;
    } else {
        for (std::size_t k = 0; k < static_cast<std::size_t>(roots.count); ++k) {
            const Ref error = abs(Ref(found.t[k]) - roots.t[k]);
            const T allowed = root_error(one.sphere, bound, T(1), found.t[k]);
            share = max_of(share, static_cast<double>(error / Ref(allowed)));
        }
    }
    if (!outcome.judge(share)) {
        tally.describe<T>([&](std::ostream& out) {
            out << "sphere at " << vector_cast<double>(one.sphere.center) << " of radius "
                << static_cast<double>(one.sphere.radius) << ", ray from "
                << vector_cast<double>(one.ray.origin) << " along "
                << vector_cast<double>(one.ray.direction) << ": " << found.count
                << " roots, exactly " << roots.count;
        });
    }
}

Tally run(Random& random, std::uint64_t trials) {
    Tally tally;
    for (; tally.trials < trials; ++tally.trials) {
        try_one<double>(random, tally);
        try_one<float>(random, tally);
    }
    return tally;
}

}  // namespace

Row tangents() {
    return {"tangents",
            "rays that graze a sphere within 1 to 10^6 ulp of its radius, from 1 to 10^6 radii",
            "rays",
            "hit or miss as the reference or within the bound; roots within theirs",
            "the stated bound",
            20'000,
            10'000'000,
            10'000,
            run};
}

}  // namespace raytree::stress
