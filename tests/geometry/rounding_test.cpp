#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <vector>

#include "geometry/affine_map.h"
#include "geometry/cone.h"
#include "geometry/polygon.h"
#include "geometry/sphere_error.h"
#include "geometry/triangle.h"

// The bounds that the headers of lib/geometry state, held against the reference arithmetic on
// inputs that are hard for them: far from the origin, seen from afar, slivers, nearly flat cones.

using namespace raytree;

namespace {

constexpr double u = Real<double>::unit_roundoff;
constexpr int trials = 5'000;

using Vec = Vec3<double>;
using Exact3 = Vec3<Quad>;

Exact3 exact(const Vec& v) { return vector_cast<Quad>(v); }
double size_of(const Exact3& v) { return static_cast<double>(length<Quad>(v)); }
double size_of(Quad x) { return static_cast<double>(abs(x)); }

class Random {
  public:
    explicit Random(unsigned seed) : engine_(seed) {}

    double uniform(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine_);
    }
    double log_uniform(double low, double high) {
        return std::exp(uniform(std::log(low), std::log(high)));
    }
    Vec in_cube() { return {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)}; }
    UnitVec3<double> direction() { return UnitVec3<double>::of(in_cube() + Vec(1e-9, 0, 0)); }

  private:
    std::mt19937_64 engine_;
};

/// A size, a place up to 10^6 sizes from the origin, and a ray from up to 10^6 sizes away that
/// passes within about one size of the place.
struct Setting {
    double size;
    Vec place;
    Ray<double> ray;

    explicit Setting(Random& random)
        : size(random.log_uniform(1e-6, 1e6)),
          place(size * random.log_uniform(1e-3, 1e6) * random.in_cube()) {
        ray.origin = place + size * random.log_uniform(2, 1e6) * random.direction().vec();
        const Vec aim = place + 0.7 * size * random.in_cube();
        ray.direction = UnitVec3<double>::of(aim - ray.origin);
    }
    Ray<Quad> exact_ray() const { return {exact(ray.origin), exact(ray.direction), Quad(0)}; }
};

/// The largest error as a share of its bound: at most 1, and not so little that the bound says
/// nothing.
struct Share {
    double worst = 0;
    int count = 0;

    void add(double error, double bound) {
        worst = std::max(worst, error / bound);
        ++count;
    }
    void hold(const char* what) const {
        INFO(what, ": ", worst, " of the bound in ", count);
        CHECK(count > trials / 20);
        CHECK(worst <= 1);
        CHECK(worst > 0.005);
    }
};

}  // namespace

TEST_CASE("rounding: a sphere's roots, points and normals") {
    Random random(1);
    Share roots, off_surface, normals;
    for (int k = 0; k < trials; ++k) {
        const Setting s(random);
        const SphereShape<double> sphere{s.place, s.size};
        const SphereShape<Quad> truth{exact(s.place), s.size};
        const auto found = intersect(sphere, s.ray, Start::anywhere);
        const auto there = intersect(truth, s.exact_ray(), Start::anywhere);
        const auto bound = approach(sphere, s.ray);
        if (found.count != 2 || there.count != 2 || !(bound.square > bound.error)) {
            continue;
        }
        for (std::size_t n = 0; n < 2; ++n) {
            roots.add(size_of(Quad(found.t[n]) - there.t[n]),
                      root_error(sphere, bound, 1.0, found.t[n]));
        }
        const auto at = surface_at(sphere, s.ray, found.t[0]);
        const Exact3 from_center = exact(at.point) - truth.center;
        off_surface.add(size_of(length(from_center) - Quad(s.size)),
                        u * (4 * s.size + 2 * length(s.place)));
        // The point where the ray is at that t, taken as exact.
        const auto ideal = surface_at(truth, s.exact_ray(), Quad(found.t[0]));
        normals.add(size_of(exact(at.geometric_normal.vec()) - ideal.geometric_normal.vec()),
                    u * (4 + 2 * (length(s.ray.origin - s.place) + found.t[0]) / s.size));
    }
    roots.hold("roots");
    off_surface.hold("points");
    normals.hold("normals");
}

TEST_CASE("rounding: a cone's roots and points") {
    Random random(2);
    Share roots, off_surface;
    for (int k = 0; k < trials; ++k) {
        const Setting s(random);
        const Vec half = s.size * random.direction().vec();
        const double radius = s.size * random.log_uniform(0.1, 1);
        const double other = radius * random.uniform(0, 1);
        const auto cone = make_cone<double>(s.place - half, radius, s.place + half, other);
        const auto truth =
            make_cone<Quad>(exact(s.place - half), radius, exact(s.place + half), other);
        const auto found = intersect(cone, s.ray, Start::anywhere);
        const auto there = intersect(truth, s.exact_ray(), Start::anywhere);
        if (found.count == 0 || found.count != there.count) {
            continue;
        }
        const auto ideal = surface_at(truth, s.exact_ray(), there.t[0]);
        const double cosine = size_of(inner(ideal.geometric_normal.vec(), exact(s.ray.direction)));
        if (!(cosine > 0.05)) {
            continue;
        }
        const double extent = 2 * s.size + 2 * radius;
        const double reach = largest_component(s.place) + extent;
        const double away = length<double>(s.ray.origin - s.place) + extent;
        roots.add(size_of(Quad(found.t[0]) - there.t[0]) * cosine,
                  u * (64 * away + 16 * reach) + 4 * u * found.t[0] * cosine);
        const auto at = surface_at(cone, s.ray, found.t[0]);
        // How far from the surface: across the axis, and then along the normal.
        const AxisParts<Quad> parts = split(truth, Exact3(exact(at.point) - truth.base));
        const Quad gap = (sqrt(inner(parts.across, parts.across)) -
                          fma(truth.slope, parts.z, truth.base_radius)) /
                         sqrt(1 + truth.slope * truth.slope);
        off_surface.add(size_of(gap), u * 8 * (reach + extent));
    }
    roots.hold("roots");
    off_surface.hold("points");
}

namespace {

/// A polygon of a given kind about a place: round, or a sliver of which one side is all but lost.
std::vector<Vec> corners(Random& random, const Setting& s, int count) {
    const Vec n = random.direction();
    const Vec x = UnitVec3<double>::of(outer(n, random.direction().vec() + Vec(0.1, 0, 0)));
    const Vec y = outer(n, x);
    const double thin = random.log_uniform(1e-4, 1);
    std::vector<Vec> result;
    for (int k = 0; k < count; ++k) {
        const double angle = 2 * Real<double>::pi * (k + random.uniform(-0.3, 0.3)) / count;
        result.push_back(s.place + s.size * (std::cos(angle) * x + thin * std::sin(angle) * y));
    }
    return result;
}

std::vector<Exact3> exact(const std::vector<Vec>& points) {
    std::vector<Exact3> result;
    for (const Vec& p : points) {
        result.push_back(exact(p));
    }
    return result;
}

/// The sum of products of the edges from the first corner, and what is left of it as area.
double condition(const std::vector<Vec>& vertices) {
    double edges = 0;
    for (std::size_t k = 1; k + 1 < vertices.size(); ++k) {
        edges += length<double>(vertices[k] - vertices[0]) *
                 length<double>(vertices[k + 1] - vertices[0]);
    }
    return 4 + 8 * edges / length<double>(newell_normal<double>(vertices));
}

}  // namespace

TEST_CASE("rounding: a plane's normal, where a ray meets it, and the point put back on it") {
    Random random(3);
    Share normals, met, off_plane, triangles;
    for (int k = 0; k < trials; ++k) {
        const Setting s(random);
        const std::vector<Vec> v = corners(random, s, 3 + k % 4);
        const auto plane = supporting_plane<double>(v);
        const auto truth = supporting_plane<Quad>(exact(v));
        const double normal_bound = u * condition(v);
        normals.add(size_of(exact(plane.normal.vec()) - truth.normal.vec()), normal_bound);
        const double cosine = size_of(inner(truth.normal.vec(), exact(s.ray.direction)));
        if (!(cosine > 0.05)) {
            continue;
        }
        const double far = 1e300;
        const double t = meet(plane, s.ray, Start::anywhere, -far, far);
        const Quad there = meet(truth, s.exact_ray(), Start::anywhere, Quad(-far), Quad(far));
        const double extent = 2 * s.size;
        const double reach = largest_component(s.place) + extent;
        const double away = length<double>(s.ray.origin - s.place) + extent;
        // Of planes as far from their middle as the ray meets them.
        const double off_middle = length<double>(along(s.ray.origin, t, s.ray.direction) - s.place);
        const double bound = u * (8 * away + 4 * reach) + normal_bound * (extent + off_middle) +
                             4 * u * std::abs(t) * cosine;
        met.add(size_of(Quad(t) - there) * cosine, bound);
        const Exact3 from_plane = exact(point_on(plane, s.ray, t)) - exact(plane.point);
        off_plane.add(size_of(inner(exact(plane.normal.vec()), from_plane)),
                      u * (4 * reach + 4 * extent + 4 * off_middle));
        if (v.size() == 3) {
            const TriangleShape<double> triangle{{v[0], v[1], v[2]}};
            const double own = meet_plane(triangle, s.ray, Start::anywhere, -far, far);
            triangles.add(size_of(Quad(own) - there) * cosine, bound);
        }
    }
    normals.hold("normals");
    met.hold("t");
    off_plane.hold("points");
    triangles.hold("t of triangles");
}

TEST_CASE("rounding: places in the frame of a ray") {
    Random random(4);
    Share places, passages;
    for (int k = 0; k < trials; ++k) {
        const Setting s(random);
        const RayFrame<double> frame(s.ray.direction);
        const RayFrame<Quad> truth(exact(s.ray.direction));
        if (frame.z != truth.z) {
            continue;
        }
        const std::vector<Vec> v = corners(random, s, 5);
        for (const Vec& corner : v) {
            const Vec from = corner - s.ray.origin;
            const Exact3 exactly = exact(corner) - exact(s.ray.origin);
            const double bound = 5 * u * largest_component(from);
            places.add(size_of(Quad(frame.x_of(from)) - truth.x_of(exactly)), bound);
            places.add(size_of(Quad(frame.y_of(from)) - truth.y_of(exactly)), bound);
        }
        const auto [nearest, farthest] = passage<double>(v, s.ray, frame);
        const auto there = passage<Quad>(exact(v), s.exact_ray(), truth);
        const double reach = largest_component(s.ray.origin - s.place) + s.size;
        passages.add(size_of(Quad(nearest) - there.nearest), 4 * u * reach);
        passages.add(size_of(Quad(farthest) - there.farthest), 4 * u * reach);
    }
    places.hold("places");
    passages.hold("nearest and farthest");
}

TEST_CASE("rounding: a ray is on the same side of an edge as exactly, but within the bound") {
    Random random(5);
    Share sides;
    for (int k = 0; k < 8 * trials; ++k) {
        Setting s(random);
        const std::vector<Vec> v = corners(random, s, 3);
        const std::size_t from = static_cast<std::size_t>(k) % 3;
        const Vec a = v[from], b = v[(from + 1) % 3];
        // Within some units in the last place of the edge.
        const double aside = random.log_uniform(1e-3, 1e3) * u * length<double>(a - s.ray.origin);
        const Vec at = a + random.uniform(0, 1) * (b - a) + aside * random.in_cube();
        s.ray.direction = UnitVec3<double>::of(at - s.ray.origin);
        const TriangleShape<double> triangle{{v[0], v[1], v[2]}};
        const TriangleShape<Quad> truth{{exact(v[0]), exact(v[1]), exact(v[2])}};
        const bool met = intersect(triangle, s.ray, Start::anywhere).count > 0;
        const bool there = intersect(truth, s.exact_ray(), Start::anywhere).count > 0;
        if (met == there) {
            continue;
        }
        // How far the line passes from the nearest edge, across both.
        double nearest = 1e300;
        for (std::size_t n = 0; n < 3; ++n) {
            const Exact3 p = exact(v[n]) - exact(s.ray.origin);
            const Exact3 edge = exact(v[(n + 1) % 3]) - exact(v[n]);
            const Exact3 across = outer(edge, exact(s.ray.direction));
            const Quad wide = length(across);
            if (wide > 0) {
                nearest = std::min(nearest, size_of(inner(p, across) / wide));
            }
        }
        sides.add(nearest, 16 * u * (length<double>(s.ray.origin - s.place) + s.size));
    }
    INFO("sides: ", sides.worst, " of the bound in ", sides.count);
    CHECK(sides.count > 20);
    CHECK(sides.worst <= 1);
}

TEST_CASE("rounding: rays, points and normals through a transform") {
    Random random(6);
    Share origins, directions, points, normals;
    for (int k = 0; k < trials; ++k) {
        const Setting s(random);
        Affine m;
        for (std::size_t row = 0; row < 3; ++row) {
            const Vec r = random.log_uniform(1e-2, 1e2) * random.in_cube();
            m[row] = {r.x, r.y, r.z, s.place[static_cast<int>(row)]};
        }
        const AffineMap<double> map(m);
        const AffineMap<Quad> truth(m);
        // The condition number, by Frobenius norms.
        double forward = 0, back = 0;
        std::array<Exact3, 3> rows;
        for (std::size_t row = 0; row < 3; ++row) {
            rows[row] = {Quad(m[row][0]), Quad(m[row][1]), Quad(m[row][2])};
            forward += size_of(inner(rows[row], rows[row]));
        }
        const Quad determinant = inner(rows[0], outer(rows[1], rows[2]));
        for (std::size_t row = 0; row < 3; ++row) {
            const Exact3 column = outer(rows[(row + 1) % 3], rows[(row + 2) % 3]) / determinant;
            back += size_of(inner(column, column));
        }
        forward = std::sqrt(forward);
        back = std::sqrt(back);
        const double c = forward * back;
        const Vec own_point = random.in_cube();
        points.add(
            size_of(exact(map.point_to_world(own_point)) - truth.point_to_world(exact(own_point))),
            u * (4 * forward * length(own_point) + 2 * length(s.place)));
        const auto n = random.direction();
        normals.add(size_of(exact(map.normal_to_world(n).vec()) -
                            truth.normal_to_world(UnitVec3<Quad>::of(exact(n.vec()))).vec()),
                    8 * c * u);
        const Ray<double> own = map.ray_to_own_space(s.ray);
        const Ray<Quad> there = truth.ray_to_own_space(s.exact_ray());
        const double far = length<double>(s.ray.origin - s.place);
        origins.add(size_of(exact(own.origin) - there.origin),
                    back * u * (8 * c * far + 2 * (length(s.ray.origin) + length(s.place))));
        directions.add(size_of(exact(own.direction) - there.direction), 8 * c * back * u);
    }
    points.hold("points");
    normals.hold("normals");
    origins.hold("origins");
    directions.hold("directions");
}
