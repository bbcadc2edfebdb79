#include "accel/intersector.h"
#include "bodies.h"

namespace raytree::stress {
namespace {

/// Two polygons that share a jagged chain of edges and together make a rectangle.
struct Pair {
    Scene scene;
    std::vector<Point> chain;  ///< without its two ends, which are on the rectangle's rim
    Point center;
    double size = 1;
    Vec3<double> normal{};
};

Pair make_pair(Random& random) {
    Pair pair;
    pair.size = random.log_uniform(1e-6, 1e6);
    const double offset = random.chance(0.4) ? 0 : pair.size * random.log_uniform(1, 1e4);
    const bool upright = random.chance(0.3);  // in the planes of the axes, ties are exact
    pair.center = upright ? Point(0, 0, 0) : offset * random.direction().vec();
    const Vec3<double> n = upright ? Vec3<double>(0, 0, 1) : random.direction().vec();
    const Vec3<double> u = upright ? Vec3<double>(1, 0, 0) : random.across(n).vec();
    const Vec3<double> v = outer(n, u);
    pair.normal = n;
    const auto point = [&](double x, double y) {
        return pair.center + pair.size * (x * u + y * v);
    };
    const int teeth = 2 + static_cast<int>(random.below(12));
    Polygon above{{point(-1, 0)}, {}};
    for (int k = 1; k < teeth; ++k) {
        // Not monotone: teeth lean over each other. Some edges lie level or upright.
        const double x = -1 + 2.0 * k / teeth + (random.chance(0.3) ? 0.0 : 0.2 / teeth);
        const double y = random.chance(0.2) ? 0 : random.uniform(-0.9, 0.9);
        above.vertices.push_back(point(x, y));
        pair.chain.push_back(above.vertices.back());
    }
    above.vertices.push_back(point(1, 0));
    Polygon below = above;
    above.vertices.push_back(point(1, 1));
    above.vertices.push_back(point(-1, 1));
    below.vertices.push_back(point(1, -1));
    below.vertices.push_back(point(-1, -1));
    if (random.chance(0.5)) {
        std::ranges::reverse(below.vertices);
    }
    add(pair.scene, above);
    add(pair.scene, below);
    return pair;
}

Point target(Random& random, const Pair& pair) {
    const std::size_t k = random.below(pair.chain.size());
    const Point p = pair.chain[k];
    if (k + 1 == pair.chain.size() || random.chance(0.4)) {
        return p;
    }
    const double share = random.chance(0.3) ? 0.5 : random.uniform(0, 1);
    return p + share * (pair.chain[k + 1] - p);
}

template <class T> void shoot(const ShapeSet<T>& shapes, const Pair& pair, const Point& from,
                              const Point& at, Tally& tally) {
    const Vec3<T> eye = vector_cast<T>(from);
    const Ray<T> ray{eye, UnitVec3<T>::of(vector_cast<T>(at) - eye).vec(), T(0)};
    const int met =
        shapes.intersect(0, ray, no_primitive).count + shapes.intersect(1, ray, no_primitive).count;
    if (met != 1) {
        ++tally.in<T>().wrong;
        tally.describe<T>([&](std::ostream& out) {
            out << met << " of two polygons about " << pair.center << " of size " << pair.size
                << " met from " << from << " towards " << at;
        });
    }
}

Tally run(Random& random, std::uint64_t trials) {
    Tally tally;
    while (tally.trials < trials) {
        const Pair pair = make_pair(random);
        const ShapeSet<double> in_double(pair.scene);
        const ShapeSet<float> in_float(pair.scene);
        for (int k = 0; k < 50 && tally.trials < trials; ++k, ++tally.trials) {
            const Point at = target(random, pair);
            Vec3<double> view = random.direction();
            if (inner(view, pair.normal) < 0.02) {
                view = along(view, 0.1 - inner(view, pair.normal), pair.normal);
            }
            const Point eye = random.chance(0.2)
                                  ? at + pair.size * pair.normal
                                  : at + pair.size * random.log_uniform(0.1, 100) * view;
            shoot(in_double, pair, eye, at, tally);
            shoot(in_float, pair, eye, at, tally);
        }
    }
    return tally;
}

}  // namespace

Row polygons() {
    return {"polygons",
            "two concave polygons that share a jagged chain of edges, aimed at exactly through its "
            "vertices and edges",
            "rays",
            "each ray meets exactly one of the two",
            "",
            20'000,
            10'000'000,
            10'000,
            run};
}

}  // namespace raytree::stress
