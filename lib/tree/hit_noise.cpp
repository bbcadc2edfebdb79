#include "tree/hit_noise.h"

#include <algorithm>
#include <cmath>

#include "tree/shape_rounding.h"
#include "tree/surface_bend.h"

namespace raytree {
namespace {

using Vec = Vec3<double>;

/// Gathers the sources at a hit.
class Gathering {
  public:
    Gathering(HitNoise& at, const SurfaceBend& bend, bool front)
        : at_(at), bend_(bend), turned_(front ? 1 : -1) {}

    /// One that moves the point, turns the ray, and turns the normal where it is.
    void add(const Vec& moved, const Vec& way, const Vec& turn) {
        at_.surface.push_back({moved, turned_ * bend_.turn(moved) + turn});
        at_.direction.push_back({Vec(0, 0, 0), way});
    }
    /// One of unknown direction: three, along the axes.
    void add_any(double moved, double turn) {
        for (int axis = 0; axis < 3; ++axis) {
            Vec e(0, 0, 0);
            e[axis] = 1;
            add(moved * e, Vec(0, 0, 0), turn * e);
        }
    }
    double off() const {
        return total(at_.surface, [](const Noise& s) { return length(s.place); });
    }

  private:
    HitNoise& at_;
    const SurfaceBend& bend_;
    double turned_;
};

}  // namespace

HitNoise noise_at_hit(const World<double>& world, const World<Quad>& reference, PrimitiveId id,
                      const TreeRay<double>& ray, const NoiseList& noise, double u) {
    const TreeHit<double>& hit = *ray.hit;
    const ShapeSet<double>& shapes = world.shapes.shapes();
    const Ray<double> line{ray.origin, ray.direction, 0.0};
    const SurfacePoint<double> own = shapes.surface_at(id, line, hit.t);
    const Vec n = own.geometric_normal;
    const double speed = inner(n, ray.direction);
    const double cosine = std::max(std::abs(speed), 4 * u);
    const ShapeRounding rounding = rounding_of(reference, id, ray.origin, hit.t, u);
    const SurfaceBend bend = bend_at(shapes, id, line, hit.t, n);

    HitNoise at;
    at.primitive = id;
    at.point = hit.point;
    at.normal = hit.normal;
    at.viewing = ray.direction;
    at.front = hit.side == Side::front;
    at.speed = std::abs(speed);
    Gathering sources(at, bend, at.front);
    for (const Noise& each : noise) {
        const Vec w = each.place + hit.t * each.way;
        const double dt = -inner(n, w) / (speed < 0 ? -cosine : cosine);
        at.t_error += std::abs(dt);
        sources.add(w + dt * ray.direction, each.way, Vec(0, 0, 0));
    }
    const double slip = rounding.distance / cosine;
    at.t_error += slip + 4 * u * hit.t;
    sources.add(slip * across(ray.direction, n), Vec(0, 0, 0), Vec(0, 0, 0));
    sources.add_any(rounding.point, 0);
    sources.add_any(0, rounding.normal);
    if (bend.curvature > 0 || own.shading_normal.vec() != n) {
        const double reach = 2 * sources.off();
        const double jump = jump_within(reference.shapes.shapes(), id, line, hit.t, bend, reach);
        if (jump > 0) {
            sources.add_any(0, jump);
        }
    }
    // Of a curved surface the first order is half of it at worst, where the hit is certain.
    if (bend.curvature > 0) {
        for (Noise& source : at.surface) {
            source.place *= 2.0;
            source.way *= 2.0;
        }
        at.t_error *= 2;
    }
    return at;
}

NoiseList noise_onwards(const HitNoise& at, const TreeHit<double>& hit,
                        const TreeRay<double>& branch, double u) {
    const Vec& d = at.viewing;
    const Vec& n = at.normal;
    const double c1 = -inner(d, n);
    const bool reflected = branch.kind == RayKind::reflected;
    const double eta = reflected ? 1 : hit.interface->eta1 / hit.interface->eta2;
    const double cos2 = reflected ? 1 : std::max(0.0, 1 - hit.interface->sin2_transmitted);
    const double cos_t = std::max(std::sqrt(cos2), std::sqrt(14 * u));
    NoiseList noise;
    for (std::size_t k = 0; k < at.surface.size(); ++k) {
        const Vec& dd = at.direction[k].way;
        const Vec& dn = at.surface[k].way;
        const double dc1 = -(inner(dd, n) + inner(d, dn));
        Vec way;
        if (reflected) {
            way = dd + 2.0 * (dc1 * n + c1 * dn);
        } else {
            const double along_n = eta * c1 - std::sqrt(cos2);
            way = eta * dd + (eta * dc1 - eta * eta * c1 * dc1 / cos_t) * n + along_n * dn;
        }
        noise.push_back({at.surface[k].place, across(way, branch.direction)});
    }
    add_noise(noise, 0, 8 * u * (1 + eta));
    if (!reflected) {
        const double s2 = std::max(1.0, hit.interface->sin2_transmitted);
        noise.push_back({Vec(0, 0, 0), (8 * u * s2 / cos_t) * n});
    }
    return noise;
}

NoiseList noise_to_light(const HitNoise& at, const TreeRay<double>& shadow_ray, double u) {
    const std::optional<double>& distance = shadow_ray.shadow->distance;
    NoiseList noise;
    for (const Noise& source : at.surface) {
        noise.push_back({source.place, distance
                                           ? across(-source.place, shadow_ray.direction) / *distance
                                           : Vec(0, 0, 0)});
    }
    add_noise(noise, 0, 4 * u);
    return noise;
}

}  // namespace raytree
