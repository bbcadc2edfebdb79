#include <doctest/doctest.h>

#include "geometry/cone.h"
#include "geometry/sphere.h"

using namespace raytree;

// 10^8 radii from the origin a hit point is off its sphere by 10^-8 radii: at a flatter angle than
// that, the numbers alone do not tell to which side a ray goes on.

TEST_CASE("leaving: a ray that grazes a sphere far from the origin goes where it is sent") {
    const SphereShape<double> sphere{{1e8, 0, 0}, 1};
    const double cosine = 1e-12;
    const Vec3<double> start(1e8 + 0x1p-26 * 0.6, 0.8, 0.6);  // off by some 10^-8
    Ray<double> ray{start, {-cosine, 0, 1}, 4e-8};
    ray.direction = UnitVec3<double>::of({0, 0.6 - 0.8 * cosine, -0.8 - 0.6 * cosine});
    for (const double tilt : {1e-9, -1e-9}) {
        Ray<double> tilted = ray;
        tilted.direction = UnitVec3<double>::of(ray.direction + tilt * Vec3<double>(0, 0.8, 0.6));
        tilted.going = Going::inwards;
        CHECK(intersect(sphere, tilted, Start::on_this_shape).count == 1);
        tilted.going = Going::outwards;
        CHECK(intersect(sphere, tilted, Start::on_this_shape).count == 0);
    }
}

TEST_CASE("leaving: a ray that grazes a cylinder goes where it is sent") {
    const auto cylinder = make_cone<double>({0, 0, -1}, 1, {0, 0, 1}, 1);
    for (const double tilt : {1e-12, -1e-12}) {
        Ray<double> ray{{1, 0, 0}, UnitVec3<double>::of({tilt, 1, 0}).vec(), 4e-16};
        ray.going = Going::inwards;
        CHECK(intersect(cylinder, ray, Start::on_this_shape).count == 1);
        ray.going = Going::outwards;
        CHECK(intersect(cylinder, ray, Start::on_this_shape).count == 0);
    }
}
