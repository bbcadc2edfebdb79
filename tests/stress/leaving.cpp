#include "accel/intersector.h"
#include "bodies.h"

namespace raytree::stress {
namespace {

constexpr std::uint64_t rays_each = 64;

/// A convex body, and what a ray that leaves its surface must do.
struct Body {
    enum class Kind { closed, open_ends, slab };
    Kind kind = Kind::closed;
    Scene scene;
    Point center;
    double size = 1;
    double thickness = 0;  ///< of a slab
};

Polygon square(const Point& center, const Point& u, const Point& v) {
    return {{center - u - v, center + u - v, center + u + v, center - u + v}, {}};
}

/// Concave: an arrow head.
Polygon arrow(const Point& center, const Point& u, const Point& v) {
    return {{center + u, center + v - u, center - 0.4 * u, center - v - u}, {}};
}

/// Two plates, as they are or as unit ones that are taken there by a transform.
void add_slab(Random& random, Body& body) {
    body.kind = Body::Kind::slab;
    const bool transformed = random.chance(0.3);
    const double unit = transformed ? body.size : 1;
    const Point center = transformed ? Point(0, 0, 0) : body.center;
    const Vec3<double> n = random.direction();
    const Vec3<double> u = body.size / unit * random.across(n).vec();
    const Vec3<double> v = outer(n, u);
    const Vec3<double> half = body.thickness / 2 / unit * n;
    const std::size_t outline = random.below(3);
    const Affine there = stretched(random, body.size, 1, body.center);
    for (const double side : {1.0, -1.0}) {
        const Point at = center + side * half;
        add(body.scene, outline == 0   ? square(at, u, v)
                        : outline == 1 ? arrow(at, u, v)
                                       : Polygon{{at + u, at + v - u, at - v - u}, {}});
        if (transformed) {
            body.scene.objects.back().transform = there;
        }
    }
}

/// Any kind of surface, of size 10^-9 to 10^9, up to 10^8 times its size away from the origin.
Body make_body(Random& random) {
    Body body;
    body.size = random.log_uniform(1e-9, 1e9);
    body.thickness = body.size * random.log_uniform(1e-6, 1e-1);
    const double offset = random.chance(0.3) ? 0 : body.size * random.log_uniform(1, 1e8);
    body.center = offset * random.direction().vec();
    const Vec3<double> axis = random.direction();
    const std::size_t kind = random.below(7);
    if (kind == 0) {
        add(body.scene, Sphere{body.center, body.size});
    } else if (kind == 1) {
        add(body.scene, Sphere{random.in_cube(), random.log_uniform(0.5, 2)});
    } else if (kind == 2 || kind == 3) {
        body.kind = Body::Kind::open_ends;
        const double unit = kind == 2 ? body.size : 1;
        const Point at = kind == 2 ? body.center : Point(0, 0, 0);
        const double radius = unit * random.log_uniform(0.1, 1);
        const double other = random.chance(0.3) ? radius : radius * random.uniform(0, 1);
        add(body.scene,
            Cone{at - unit * axis, at + unit * axis, radius, random.chance(0.2) ? 0 : other});
    } else if (kind == 4) {
        const int subdivisions = static_cast<int>(random.below(3));
        add(body.scene, rough_ball(random, body.center, body.size, subdivisions, 0));
    } else {
        add_slab(random, body);
    }
    if (kind == 1 || kind == 3) {
        body.scene.objects.back().transform = stretched(random, body.size, 3, body.center);
    }
    return body;
}

template <class T> T origin_error(const Vec3<T>& point) {
    return 4 * Real<T>::unit_roundoff * largest_component(point);
}

/// A unit direction on either side of a surface, grazing it more often than not.
template <class T> Vec3<T> onwards(Random& random, const Vec3<T>& normal) {
    const double cosine = random.log_uniform(1e-14, 1) * (random.chance(0.5) ? 1 : -1);
    const Vec3<double> n = vector_cast<double>(normal);
    const Vec3<double> across = random.across(n);
    return UnitVec3<T>::of(vector_cast<T>(
        along(Vec3<double>(std::sqrt((1 - cosine) * (1 + cosine)) * across), cosine, n)));
}

/// What is asked of the ray onwards.
enum class Expected { hit, no_hit, either };

/// Of the reference, which starts at the same point: of a closed convex body everything is known.
template <class T> class Judge {
  public:
    explicit Judge(const Body& body) : body_(body), own_(body.scene), exact_(body.scene) {}

    void shoot(Random& random, Tally& tally) {
        NoTestCount count;
        const Vec3<T> eye = vector_cast<T>(body_.center + (random.chance(0.7) ? 6 : 0.1) *
                                                              body_.size * random.in_cube());
        const Vec3<T> aim = vector_cast<T>(body_.center + 0.6 * body_.size * random.in_cube());
        if (eye == aim) {
            return;
        }
        const Ray<T> primary{eye, UnitVec3<T>::of(aim - eye).vec(), T(0)};
        const auto hit = own_.closest(primary, no_primitive, {}, count);
        if (!hit) {
            return;
        }
        const SurfacePoint<T> at = own_.shapes().surface_at(hit->primitive, primary, hit->t);
        Ray<T> ray{at.point, onwards(random, at.geometric_normal.vec()), origin_error(at.point)};
        const T cosine = inner(at.geometric_normal, ray.direction);
        if (cosine == 0) {
            return;
        }
        ray.going = cosine > 0 ? Going::outwards : Going::inwards;
        const auto next = own_.closest(ray, hit->primitive, {}, count);
        judge(ray, static_cast<double>(cosine), hit->primitive, next, tally);
    }

  private:
    void judge(const Ray<T>& ray, double cosine, PrimitiveId leaving,
               const std::optional<Hit<T>>& next, Tally& tally) {
        const Expected expected = expect(ray, cosine, leaving);
        const bool self_hit = next && next->primitive == leaving && is_flat();
        Outcome& outcome = tally.in<T>();
        if (!self_hit &&
            (expected == Expected::either ||
             (next.has_value() != (expected == Expected::hit) && passes_over_rim(ray, leaving)))) {
            ++outcome.undecided;
        } else if (self_hit || next.has_value() != (expected == Expected::hit)) {
            ++outcome.wrong;
            tally.describe<T>([&](std::ostream& out) {
                out << body_.scene.objects[0].shape.index() << "-th shape of size " << body_.size
                    << " at " << body_.center << ", leaving primitive " << leaving << " at "
                    << vector_cast<double>(ray.origin) << " with cosine " << cosine
                    << (next ? ": hits itself" : ": passes through");
            });
        }
    }

    Expected expect(const Ray<T>& ray, double cosine, PrimitiveId leaving) const {
        if (body_.kind == Body::Kind::slab) {
            return expect_of_slab(ray, cosine, leaving);
        }
        const bool is_mesh = std::holds_alternative<Mesh>(body_.scene.objects[0].shape);
        if (is_mesh && std::abs(cosine) * body_.size <= 4 * slack(ray)) {
            return Expected::either;  // it stays as close to its own face as it may be off it
        }
        if (cosine > 0) {
            return Expected::no_hit;
        }
        if (body_.kind == Body::Kind::open_ends) {
            return expect_of_cone(ray, cosine, leaving);
        }
        return is_near_neighbour(ray, leaving) ? Expected::either : Expected::hit;
    }

    /// What is made of planes cannot be met again where it has just been left.
    bool is_flat() const {
        return body_.kind == Body::Kind::slab ||
               std::holds_alternative<Mesh>(body_.scene.objects[0].shape);
    }

    Ray<Quad> exact(const Ray<T>& ray) const {
        return {vector_cast<Quad>(ray.origin), vector_cast<Quad>(ray.direction), Quad(0)};
    }

    double slack(const Ray<T>& ray) const { return 16 * static_cast<double>(ray.origin_error); }

    /// Whether the ray starts on another face of the mesh too, within the bound.
    bool is_near_neighbour(const Ray<T>& ray, PrimitiveId leaving) const {
        const auto* mesh = std::get_if<Mesh>(&body_.scene.objects[0].shape);
        for (std::size_t k = 0; mesh && k < mesh->triangles.size(); ++k) {
            std::array<Vec3<double>, 3> v;
            for (std::size_t c = 0; c < 3; ++c) {
                v[c] = mesh->vertices[static_cast<std::size_t>(mesh->triangles[k][c].vertex)];
            }
            const auto normal = UnitVec3<double>::of(outer<double>(v[1] - v[0], v[2] - v[0]));
            const double off = inner(normal, vector_cast<double>(ray.origin) - v[0]);
            if (k != leaving && std::abs(off) <= 2 * slack(ray)) {
                return true;
            }
        }
        return false;
    }

    /// Whether the ray, were its start off its own face by no more than the bound, would pass over
    /// the face's rim without meeting another face of the mesh.
    bool passes_over_rim(const Ray<T>& ray, PrimitiveId leaving) const {
        if (!std::holds_alternative<Mesh>(body_.scene.objects[0].shape)) {
            return false;
        }
        Ray<Quad> higher = exact(ray);
        const auto normal = exact_.surface_at(leaving, higher, Quad(0)).geometric_normal;
        higher.origin = along(higher.origin, Quad(slack(ray)), normal.vec());
        for (PrimitiveId id = 0; id < exact_.size(); ++id) {
            if (id != leaving && exact_.intersect(id, higher, no_primitive).count > 0) {
                return false;
            }
        }
        return true;
    }

    /// Where the exact ray from this start leaves the infinite cone, and whether that is between
    /// its ends by more than the start is off.
    Expected expect_of_cone(const Ray<T>& ray, double cosine, PrimitiveId leaving) const {
        const double room =
            slack(ray) / body_.size / std::abs(cosine) + 1e3 * slack(ray) / body_.size;
        const auto exits = [&](double z_room) {
            Scene longer = body_.scene;
            auto& cone = std::get<Cone>(longer.objects[0].shape);
            const Point axis = cone.apex - cone.base;
            const double widening = cone.apex_radius - cone.base_radius;
            // No farther than to the tip: it would be another cone.
            const double below =
                widening > 0 ? std::min(z_room, cone.base_radius / widening) : z_room;
            const double above =
                widening < 0 ? std::min(z_room, cone.apex_radius / -widening) : z_room;
            cone.base -= below * axis;
            cone.apex += above * axis;
            cone.base_radius -= below * widening;
            cone.apex_radius += above * widening;
            const ShapeSet<Quad> shapes(longer);
            Ray<Quad> start = exact(ray);
            start.going = Going::inwards;
            return shapes.intersect(leaving, start, leaving).count > 0;
        };
        if (room > 0.01) {
            return Expected::either;
        }
        const bool wide = exits(room), narrow = exits(-room);
        return wide != narrow ? Expected::either : wide ? Expected::hit : Expected::no_hit;
    }

    /// Into the slab, the other face is met where all exact rays meet it that start as far away as
    /// the start may be off: nearer to the face and farther, and to both sides.
    Expected expect_of_slab(const Ray<T>& ray, double cosine, PrimitiveId leaving) const {
        if (body_.thickness <= 8 * slack(ray)) {
            return Expected::either;
        }
        if ((leaving == 0) != (cosine < 0)) {
            return Expected::no_hit;
        }
        const PrimitiveId other = 1 - leaving;
        const Ray<Quad> straight = exact(ray);
        const Vec3<Quad> n = exact_.surface_at(leaving, straight, Quad(0)).geometric_normal;
        const Vec3<Quad> u = UnitVec3<Quad>::of(outer(n, straight.direction));
        int met = 0, tried = 0;
        for (const Vec3<Quad>& aside : {n, Vec3<Quad>(-n), u, Vec3<Quad>(-u)}) {
            Ray<Quad> beside = straight;
            beside.origin = along(beside.origin, Quad(slack(ray)), aside);
            met += exact_.intersect(other, beside, no_primitive).count;
            ++tried;
        }
        return met == tried ? Expected::hit : met == 0 ? Expected::no_hit : Expected::either;
    }

    const Body& body_;
    Intersector<T> own_;
    ShapeSet<Quad> exact_;
};

Tally run(Random& random, std::uint64_t trials) {
    Tally tally;
    while (tally.trials < trials) {
        const Body body = make_body(random);
        Judge<double> in_double(body);
        auto in_float = if_accepted<Judge<float>>(body);
        for (std::uint64_t k = 0; k < rays_each && tally.trials < trials; ++k, ++tally.trials) {
            in_double.shoot(random, tally);
            if (in_float) {
                in_float->shoot(random, tally);
            } else {
                ++tally.in_float.undecided;
            }
        }
    }
    return tally;
}

}  // namespace

Row leaving() {
    return {"leaving",
            "rays that leave spheres, ellipsoids, cones, meshes and (concave) plates, of size "
            "10^-9 to 10^9, "
            "up to 10^8 sizes from the origin, at cosines down to 10^-14",
            "rays",
            "none meets again where it starts, none passes through the body",
            "",
            20'000,
            100'000'000,
            6'400,
            run};
}

}  // namespace raytree::stress
