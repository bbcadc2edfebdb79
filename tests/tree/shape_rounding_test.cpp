#include "tree/shape_rounding.h"

#include <doctest/doctest.h>

#include <random>

#include "support/scenes.h"

using namespace raytree;

namespace {

/// The largest error of t, along the normal, and of the normal, as shares of their bounds.
struct Worst {
    double distance = 0, normal = 0;
    int hits = 0;
};

Worst try_shapes(unsigned seed, double size, const Point& center) {
    const Scene scene = test::random_shapes(60, seed, size, center);
    const World<double> own(scene);
    const World<Quad> reference(scene);
    const auto& shapes = own.shapes.shapes();
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const auto point = [&] { return Point(uniform(random), uniform(random), uniform(random)); };
    constexpr double u = Real<double>::unit_roundoff;
    Worst worst;
    for (PrimitiveId id = 0; id < shapes.size(); ++id) {
        for (int k = 0; k < 40; ++k) {
            const double away = size * std::pow(10, 3 * uniform(random) + 3);
            const Point eye = center + away * point();
            const Point aim = shapes.bounds(id).center() +
                              0.4 * largest_component(shapes.bounds(id).size()) * point();
            const Ray<double> ray{eye, UnitVec3<double>::of(aim - eye).vec(), 0};
            const Ray<Quad> exact_ray{vector_cast<Quad>(ray.origin),
                                      vector_cast<Quad>(ray.direction), 0};
            const auto found = shapes.intersect(id, ray, no_primitive);
            const auto exact = reference.shapes.shapes().intersect(id, exact_ray, no_primitive);
            if (found.count == 0 || found.count != exact.count) {
                continue;  // which of both is right is asked elsewhere
            }
            const Quad t = exact.t[0];
            const auto at = reference.shapes.shapes().surface_at(id, exact_ray, t);
            const auto bound = rounding_of(reference, id, ray.origin, found.t[0], u);
            const auto cosine =
                static_cast<double>(abs(inner(at.geometric_normal, exact_ray.direction)));
            const auto error = static_cast<double>(abs(Quad(found.t[0]) - t));
            // Of a tangent ray the first order says nothing; sphere_error.h has the rest.
            if (cosine > 1e-2) {
                worst.distance = std::max(worst.distance,
                                          (error - 4 * u * found.t[0]) * cosine / bound.distance);
                const auto own_at = shapes.surface_at(id, ray, found.t[0]);
                const bool flat =
                    shapes[id].kind == ShapeKind::polygon || shapes[id].kind == ShapeKind::triangle;
                if (flat) {  // elsewhere it turns with the point
                    worst.normal = std::max(worst.normal,
                                            static_cast<double>(length<Quad>(
                                                vector_cast<Quad>(own_at.geometric_normal.vec()) -
                                                at.geometric_normal.vec())) /
                                                bound.normal);
                }
                ++worst.hits;
            }
        }
    }
    return worst;
}

}  // namespace

TEST_CASE("rounding: t and normals are within the bounds stated, for every kind of shape") {
    for (const double size : {1e-9, 1.0, 1e9}) {
        for (const double offset : {0.0, 1e4, 1e8}) {
            CAPTURE(size);
            CAPTURE(offset);
            const Worst worst = try_shapes(5, size, Point(offset * size));
            CHECK(worst.hits > 500);
            CHECK(worst.distance <= 1);
            CHECK(worst.normal <= 1);
            // Nor are they so wide that they say nothing.
            CHECK(worst.distance > 1e-3);
        }
    }
}
