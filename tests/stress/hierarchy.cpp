#include "accel/intersector.h"
#include "bodies.h"

namespace raytree::stress {
namespace {

constexpr int rays_each = 100;
constexpr std::size_t rays_of_a_beam = 16;  ///< that go much the same way

Polygon quad(const Point& at, const Point& u, const Point& v) {
    return {{at, at + u, at + u + v, at + v}, {}};
}

Shape any_shape(Random& random, const Point& at, double size) {
    switch (random.below(4)) {
        case 0:
            return Sphere{at, size * random.log_uniform(1e-3, 1)};
        case 1:
            return quad(at, size * random.in_cube(), size * random.in_cube());
        case 2:
            return Polygon{{at, at + size * random.in_cube(), at + size * random.in_cube()}, {}};
        default:
            return Cone{at, at + size * random.in_cube(), size * random.uniform(0.1, 1),
                        random.chance(0.3) ? 0 : size * random.uniform(0, 1)};
    }
}

void scatter(Random& random, Scene& scene, std::size_t count, double scale, const Point& center) {
    for (std::size_t k = 0; k < count; ++k) {
        add(scene, any_shape(random, center + scale * random.in_cube(), 0.3 * scale));
        if (random.chance(0.1)) {
            scene.objects.back().transform =
                stretched(random, 1, 3, 0.1 * scale * random.in_cube());
        }
    }
}

/// Everything in one place: the same shapes again and again.
void coincide(Random& random, Scene& scene, std::size_t count, double scale, const Point& center) {
    const Point at = center + scale * random.in_cube();
    std::array<Shape, 5> shapes;
    for (std::size_t k = 0; k < shapes.size(); ++k) {
        Random same(7, k);
        shapes[k] = any_shape(same, at, scale);
    }
    for (std::size_t k = 0; k < count; ++k) {
        add(scene, shapes[k % shapes.size()]);
    }
}

/// Boxes without thickness, many of them in one plane.
void flatten(Random& random, Scene& scene, std::size_t count, double scale, const Point& center) {
    const int axis = static_cast<int>(random.below(3));
    for (std::size_t k = 0; k < count; ++k) {
        Point at = center + scale * random.in_cube();
        at[axis] = center[axis] + 0.25 * scale * static_cast<double>(random.below(3));
        Point u(0, 0, 0), v(0, 0, 0);
        u[(axis + 1) % 3] = scale * random.log_uniform(1e-3, 1);
        v[(axis + 2) % 3] = scale * random.log_uniform(1e-3, 1);
        add(scene, quad(at, u, v));
    }
}

/// One inside the other, like an onion, and around them something far larger.
void nest(Random& random, Scene& scene, std::size_t count, double scale, const Point& center) {
    for (std::size_t k = 0; k < count; ++k) {
        const double size = scale * static_cast<double>(k + 1) / static_cast<double>(count);
        add(scene, Sphere{center, random.chance(0.01) ? 1e6 * scale : size});
    }
}

/// From a needle's eye to a haystack: sizes over twelve orders of magnitude.
void mix_scales(Random& random, Scene& scene, std::size_t count, double scale,
                const Point& center) {
    for (std::size_t k = 0; k < count; ++k) {
        const double size = scale * random.log_uniform(1e-9, 1e3);
        add(scene, any_shape(random, center + size * random.in_cube(), size));
    }
}

Scene make_scene(Random& random, double& scale, Point& center, std::uint64_t trials) {
    using Fill = void (*)(Random&, Scene&, std::size_t, double, const Point&);
    constexpr Fill fills[] = {scatter, coincide, flatten, nest, mix_scales};
    Scene scene;
    scale = random.log_uniform(1e-6, 1e6);
    center = random.chance(0.4) ? Point(0, 0, 0)
                                : scale * random.log_uniform(1, 1e6) * random.direction().vec();
    std::size_t count = 1 + static_cast<std::size_t>(random.log_uniform(1, 3000));
    const std::size_t kind = random.below(std::size(fills));
    if (trials >= 20'000'000) {  // now and then 10^5 at one point
        count = 100'000;
    }
    fills[trials >= 20'000'000 ? 1 : kind](random, scene, count, scale, center);
    return scene;
}

template <class T> std::vector<Hit<T>> by_force(const ShapeSet<T>& shapes, const Ray<T>& ray,
                                                PrimitiveId leaving, Interval<T> interval) {
    std::vector<Hit<T>> hits;
    for (PrimitiveId id = 0; id < shapes.size(); ++id) {
        const auto roots = shapes.intersect(id, ray, leaving);
        for (std::size_t k = 0; k < static_cast<std::size_t>(roots.count); ++k) {
            if (roots.t[k] >= interval.from && roots.t[k] < interval.to) {
                hits.push_back({roots.t[k], id});
            }
        }
    }
    std::sort(hits.begin(), hits.end());
    return hits;
}

template <class T> bool same(const Hit<T>& a, const Hit<T>& b) {
    return a.t == b.t && a.primitive == b.primitive;
}

template <class T> class Comparison {
  public:
    explicit Comparison(const Scene& scene) : own_(scene) {}

    void shoot(Random& random, double scale, const Point& center, Tally& tally) {
        NoTestCount none;
        Point direction = random.direction();
        for (int axis = 0; axis < 3; ++axis) {
            if (random.chance(0.15)) {
                direction[axis] = random.chance(0.5) ? 0.0 : -0.0;
            }
        }
        if (!(largest_component(direction) > 0)) {
            return;
        }
        const double reach = random.chance(0.2) ? random.log_uniform(1e1, 1e14) : 1.5;
        const Point eye = random.chance(0.2) ? center : center + reach * scale * random.in_cube();
        Ray<T> ray{vector_cast<T>(eye), UnitVec3<T>::of(vector_cast<T>(direction)).vec(), T(0)};
        if (reach > 2) {  // towards the shapes
            const Point aim = center + scale * random.in_cube();
            const Vec3<T> way = vector_cast<T>(aim) - ray.origin;
            if (largest_component(way) > 0) {
                ray.direction = UnitVec3<T>::of(way);
            }
        }
        PrimitiveId leaving = no_primitive;
        const auto start = own_.closest(ray, no_primitive, {}, none);
        if (random.chance(0.4) && start) {  // go on from a surface
            leaving = start->primitive;
            ray.origin = own_.shapes().surface_at(leaving, ray, start->t).point;
            ray.origin_error = 4 * Real<T>::unit_roundoff * largest_component(ray.origin);
            ray.direction = UnitVec3<T>::of(vector_cast<T>(random.direction().vec()));
        }
        Interval<T> interval;
        if (random.chance(0.3)) {
            interval.to = static_cast<T>(scale * random.uniform(0, 2));
        }
        if (random.chance(0.1)) {
            interval.from = static_cast<T>(scale * random.uniform(0, 1));
        }
        const Query<T> query{ray, leaving, interval};
        compare(query, tally);
        if (random.chance(1.0 / rays_of_a_beam)) {
            shoot_beam(random, query, scale, tally);
        }
    }

    /// Asks again what was asked one by one, many at a time.
    void compare_together(Tally& tally) { ask_together(0, Together::any_order, tally); }

  private:
    /// The ray with others beside it, which must meet together what each meets alone.
    void shoot_beam(Random& random, const Query<T>& middle, double scale, Tally& tally) {
        const std::size_t first = queries_.size();
        const double width = random.log_uniform(1e-9, 1);
        for (std::size_t k = 0; k < rays_of_a_beam; ++k) {
            Query<T> query = middle;
            const Vec3<T> aside = vector_cast<T>(width * random.in_cube());
            query.ray.direction = UnitVec3<T>::of(Vec3<T>(middle.ray.direction + aside));
            if (middle.leaving == no_primitive && random.chance(0.5)) {
                query.ray.origin += vector_cast<T>(0.1 * width * scale * random.in_cube());
            }
            compare(query, tally);
        }
        ask_together(first, Together::coherent, tally);
    }

    void ask_together(std::size_t first, Together how, Tally& tally) {
        const auto queries = std::span(std::as_const(queries_)).subspan(first);
        std::vector<Hit<T>> hits(queries.size());
        std::vector<std::uint8_t> met(queries.size());
        own_.closest(queries, hits, how);
        own_.any(queries, met, how);
        for (std::size_t k = 0; k < queries.size(); ++k) {
            const std::optional<Hit<T>>& truth = nearest_[first + k];
            const bool hit = hits[k].primitive != no_primitive;
            if (hit != truth.has_value() || (hit && !same(hits[k], *truth)) ||
                (met[k] != 0) != hit) {
                ++tally.in<T>().wrong;
                tally.describe<T>([&](std::ostream& out) {
                    out << own_.shapes().size() << " shapes, "
                        << (how == Together::coherent ? "a beam" : "many rays") << ", that from "
                        << vector_cast<double>(queries[k].ray.origin) << " along "
                        << vector_cast<double>(queries[k].ray.direction) << " leaving "
                        << queries[k].leaving << " meets something else together than alone";
                });
            }
        }
    }

    void compare(const Query<T>& query, Tally& tally) {
        const auto& [ray, leaving, interval] = query;
        NoTestCount none;
        const auto truth = by_force(own_.shapes(), ray, leaving, interval);
        const auto all = own_.all(ray, leaving, interval, none);
        const auto closest = own_.closest(ray, leaving, interval, none);
        const bool any = own_.any(ray, leaving, interval, none);
        const bool agree = std::ranges::equal(all, truth, same<T>) && any == !truth.empty() &&
                           closest.has_value() == !truth.empty() &&
                           (truth.empty() || same(*closest, truth[0]));
        queries_.push_back(query);
        nearest_.push_back(truth.empty() ? std::nullopt : std::optional(truth[0]));
        if (std::is_same_v<T, double>) {
            tally.trials += own_.shapes().size();
        }
        if (!agree) {
            ++tally.in<T>().wrong;
            tally.describe<T>([&](std::ostream& out) {
                out << own_.shapes().size() << " shapes, ray from "
                    << vector_cast<double>(ray.origin) << " along "
                    << vector_cast<double>(ray.direction) << " leaving " << leaving << ": "
                    << all.size() << " hits, by force " << truth.size();
            });
        }
    }

    Intersector<T> own_;
    std::vector<Query<T>> queries_;
    std::vector<std::optional<Hit<T>>> nearest_;  ///< by force
};

Tally run(Random& random, std::uint64_t trials) {
    Tally tally;
    while (tally.trials < trials) {
        double scale = 1;
        Point center;
        const Scene scene = make_scene(random, scale, center, trials - tally.trials);
        Comparison<double> in_double(scene);
        auto in_float = if_accepted<Comparison<float>>(scene);
        for (int k = 0; k < rays_each && tally.trials < trials; ++k) {
            in_double.shoot(random, scale, center, tally);
            if (in_float && k % 10 == 0) {
                in_float->shoot(random, scale, center, tally);
            }
        }
        in_double.compare_together(tally);
        if (in_float) {
            in_float->compare_together(tally);
        }
    }
    return tally;
}

}  // namespace

Row hierarchy() {
    return {
        "hierarchy",
        "the hierarchy against every shape one by one: scattered, coincident (up to 10^5 in one "
        "place), flat, nested shapes and such of all sizes; closest, any and all hits, one ray at "
        "a time, in beams of sixteen and many together (a tenth of it in `float`)",
        "tests",
        "the same hits, to the last bit",
        "",
        3'000'000,
        10'000'000'000,
        30'000'000,
        run};
}

}  // namespace raytree::stress
