#include <array>
#include <cmath>

#include "geometry/polygon.h"
#include "geometry/sphere.h"
#include "stress.h"
#include "trace/shading.h"

namespace raytree::stress {
namespace {

constexpr std::size_t bounces = 64;
// With three of them, in some 25 of 10^6 corridors all happened to stay close, and an ordinary
// error looked large beside them.
constexpr int neighbours = 12;

/// Two mirrors that face each other, nearly parallel, or the inside of a ball.
struct Corridor {
    bool ball = false;
    std::array<std::array<Vec3<double>, 4>, 2> mirrors;
    Vec3<double> center{};
    double radius = 1;
    Vec3<double> eye{}, aim{};
};

/// Where a ray is after each bounce.
template <class T> struct Path {
    std::size_t length = 0;
    std::array<Vec3<T>, bounces> points;
    std::array<Vec3<T>, bounces> directions;
};

Corridor make_corridor(Random& random) {
    Corridor c;
    c.ball = random.chance(0.3);
    const double size = random.log_uniform(1e-3, 1e3);
    const Vec3<double> away = random.chance(0.5)
                                  ? Vec3<double>(0, 0, 0)
                                  : size * random.log_uniform(1, 1e4) * random.direction().vec();
    c.center = away;
    c.radius = size;
    const Vec3<double> n = random.direction();
    const Vec3<double> u = random.across(n);
    const Vec3<double> v = outer(n, u);
    for (int side = 0; side < 2; ++side) {
        const double tilt = random.chance(0.3) ? 0 : random.log_uniform(1e-9, 1e-3);
        const Vec3<double> at = away + (side == 0 ? 1 : -1) * size * n;
        const Vec3<double> x = 300 * size * (u + tilt * n);
        const Vec3<double> y = 300 * size * v;
        c.mirrors[static_cast<std::size_t>(side)] = {at - x - y, at + x - y, at + x + y,
                                                     at - x + y};
    }
    c.eye = away + 0.5 * size * random.in_cube();
    c.aim = c.eye + size * (n + random.uniform(0, 1) * random.direction().vec());
    return c;
}

/// Moves every number so many units in the last place of T higher or lower.
template <class T> class Nudge {
  public:
    /// Moves nothing.
    Nudge() = default;
    Nudge(Random& random, double ulps) : random_(&random), ulps_(ulps) {}

    template <class Number> void operator()(Number& x) const { move(x, abs(x)); }
    /// Each component by one unit in the last place of the largest.
    template <class Number> void operator()(Vec3<Number>& p) const {
        const Number size = largest_component(p);
        for (int k = 0; k < 3; ++k) {
            move(p[k], size);
        }
    }

  private:
    template <class Number> void move(Number& x, Number size) const {
        if (random_) {
            const Number step =
                static_cast<Number>(ulps_ * 2 * static_cast<double>(Real<T>::unit_roundoff)) * size;
            x += random_->chance(0.5) ? step : -step;
        }
    }

    Random* random_ = nullptr;
    double ulps_ = 0;
};

template <class T> Corridor moved(const Nudge<T>& nudge, const Corridor& c) {
    Corridor result = c;
    for (auto& mirror : result.mirrors) {
        for (auto& vertex : mirror) {
            nudge(vertex);
        }
    }
    nudge(result.center);
    nudge(result.radius);
    nudge(result.eye);
    nudge(result.aim);
    return result;
}

/// Follows the ray in the arithmetic T, as the tracer does; `nudge` moves it at every bounce.
template <class T, class Own> Path<T> follow(const Corridor& c, const Nudge<Own>& nudge) {
    std::array<PolygonShape<T>, 2> mirrors;
    for (std::size_t k = 0; k < 2; ++k) {
        std::array<Vec3<T>, 4> vertices;
        std::ranges::transform(c.mirrors[k], vertices.begin(), vector_cast<T, double>);
        mirrors[k] = make_polygon<T>(vertices, {});
    }
    const SphereShape<T> ball{vector_cast<T>(c.center), static_cast<T>(c.radius)};
    const Vec3<T> eye = vector_cast<T>(c.eye);
    Ray<T> ray{eye, UnitVec3<T>::of(vector_cast<T>(c.aim) - eye).vec(), T(0)};
    Path<T> path;
    for (std::size_t k = 0; k < bounces; ++k) {
        const bool first = k == 0;
        const PolygonShape<T>& mirror = mirrors[k % 2];
        const Roots<T> roots =
            c.ball ? intersect(ball, ray, first ? Start::anywhere : Start::on_this_shape)
                   : intersect(mirror, ray, first ? Start::anywhere : Start::on_another_shape);
        if (roots.count == 0) {
            break;
        }
        const SurfacePoint<T> at =
            c.ball ? surface_at(ball, ray, roots.t[0]) : surface_at(mirror, ray, roots.t[0]);
        const bool front = inner(ray.direction, at.geometric_normal.vec()) < 0;
        const Vec3<T> n = front ? at.geometric_normal.vec() : -at.geometric_normal.vec();
        ray = {at.point, reflected_direction(ray.direction, n).vec(),
               4 * Real<T>::unit_roundoff * largest_component(at.point), Going::inwards};
        nudge(ray.origin);
        nudge(ray.direction);
        path.points[k] = ray.origin;
        path.directions[k] = ray.direction;
        path.length = k + 1;
    }
    return path;
}

template <class A, class B> double apart(const Vec3<A>& a, const Vec3<B>& b) {
    return static_cast<double>(length<B>(vector_cast<B>(a) - b));
}

/// How far the ray may be off, over what one unit in the last place of everything does to it.
constexpr double allowed = 10;

/// How many units in the last place the neighbours of a ray are moved. A unit of `float` is seen by
/// double as it is; one of `double` is not, but 2^20 are, and the way they move a ray is as much
/// larger: 2^-32 of a length is next to nothing still.
template <class T> constexpr double step_ulps = std::is_same_v<T, float> ? 1 : 0x1p20;

/// How far one unit in the last place of T moves the exact ray, of the input and at each bounce so
/// far: the root mean square over some neighbours, in double.
struct Sensitivity {
    std::size_t length = bounces;
    std::array<double, bounces> points{}, directions{};
};

template <class T> Sensitivity sensitivity(Random& random, const Corridor& c) {
    Sensitivity result;
    const Nudge<T> nudge(random, step_ulps<T>);
    const Path<double> straight = follow<double>(c, Nudge<T>());
    result.length = straight.length;
    for (int run = 0; run < neighbours; ++run) {
        const Path<double> other = follow<double>(moved(nudge, c), nudge);
        result.length = min_of(result.length, other.length);
        double worst_point = 0, worst_direction = 0;
        for (std::size_t k = 0; k < result.length; ++k) {
            worst_point = max_of(worst_point, apart(other.points[k], straight.points[k]));
            worst_direction =
                max_of(worst_direction, apart(other.directions[k], straight.directions[k]));
            result.points[k] += worst_point * worst_point;
            result.directions[k] += worst_direction * worst_direction;
        }
    }
    for (std::size_t k = 0; k < bounces; ++k) {
        result.points[k] = std::sqrt(result.points[k] / neighbours) / step_ulps<T>;
        result.directions[k] = std::sqrt(result.directions[k] / neighbours) / step_ulps<T>;
    }
    return result;
}

/// The corridor that T can hold.
template <class T> Corridor rounded(Corridor c) {
    if constexpr (std::is_same_v<T, float>) {
        const auto round = [](Vec3<double>& p) { p = vector_cast<double>(vector_cast<float>(p)); };
        for (auto& mirror : c.mirrors) {
            std::ranges::for_each(mirror, round);
        }
        round(c.center);
        round(c.eye);
        round(c.aim);
        c.radius = static_cast<double>(static_cast<float>(c.radius));
    }
    return c;
}

template <class T> void try_one(Random& random, const Corridor& given, Tally& tally) {
    using Ref = Reference<T>;
    const Corridor c = rounded<T>(given);
    const Path<T> own = follow<T>(c, Nudge<T>());
    const Path<Ref> exact = follow<Ref>(c, Nudge<T>());
    const Sensitivity moves = sensitivity<T>(random, c);
    const std::size_t length = min_of(exact.length, moves.length);
    Outcome& outcome = tally.in<T>();
    double share = own.length < length ? 2 : 0;
    const double ulp = 2 * static_cast<double>(Real<T>::unit_roundoff);
    for (std::size_t k = 0; k < min_of(length, own.length); ++k) {
        const double size = static_cast<double>(largest_component(exact.points[k]));
        share = max_of(share, apart(own.points[k], exact.points[k]) /
                                  (allowed * moves.points[k] + ulp * size));
        share = max_of(share, apart(own.directions[k], exact.directions[k]) /
                                  (allowed * moves.directions[k] + ulp));
    }
    if (!outcome.judge(share)) {
        tally.describe<T>([&](std::ostream& out) {
            out << (c.ball ? "a ball" : "two mirrors") << " about " << c.center << " of size "
                << c.radius << ", from " << c.eye << " towards " << c.aim << ": " << share
                << " of what is allowed";
        });
    }
}

Tally run(Random& random, std::uint64_t trials) {
    Tally tally;
    for (; tally.trials < trials; ++tally.trials) {
        const Corridor c = make_corridor(random);
        try_one<double>(random, c, tally);
        try_one<float>(random, c, tally);
    }
    return tally;
}

}  // namespace

Row corridors() {
    return {
        "corridors",
        "64 bounces between two mirrors, parallel or nearly so, and inside a ball",
        "rays",
        "at every bounce, point and direction are off by no more than 10 times what changes of the "
        "input and of each bounce by one ulp do to the reference (root mean square of 12)",
        "that",
        200,
        1'000'000,
        100,
        run};
}

}  // namespace raytree::stress
