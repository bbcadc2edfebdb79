#include "tree/doubts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "tree/shape_rounding.h"

namespace raytree {
namespace {

using Vec = Vec3<double>;

/// Eight directions across `axis`.
std::array<Vec, 8> rim(const Vec& axis) {
    const Vec other = std::abs(axis.x) < 0.6 ? Vec(1, 0, 0) : Vec(0, 1, 0);
    const Vec x = UnitVec3<double>::of(outer(axis, other));
    const Vec y = outer(axis, x);
    constexpr double s = 0.70710678118654752;
    return {x, -x, y, -y, s * (x + y), s * (x - y), s * (y - x), -s * (x + y)};
}

template <class T> Interval<T> interval_cast(const Interval<Quad>& interval) {
    return {static_cast<T>(interval.from), static_cast<T>(interval.to)};
}

}  // namespace

std::string ulps_text(double ulps) {
    std::array<char, 32> text;
    std::snprintf(text.data(), text.size(), "%.2g ulp", std::max(1.0, std::ceil(ulps)));
    return text.data();
}

double DoubtFinder::t_error(PrimitiveId id, const TreeRay<double>& ray, double t,
                            const NoiseList& noise) const {
    const Ray<Quad> line{vector_cast<Quad>(ray.origin), vector_cast<Quad>(ray.direction), Quad(0)};
    const auto at = reference_.shapes.shapes().surface_at(id, line, Quad(t));
    const Vec n = vector_cast<double>(at.geometric_normal.vec());
    const double cosine = std::max(std::abs(inner(n, ray.direction)), std::sqrt(u_));
    const double moved = total(noise, [&](const Noise& source) {
        return std::abs(inner(n, source.place + t * source.way));
    });
    return 4 * u_ * t +
           2 * (moved + rounding_of(reference_, id, ray.origin, t, u_).distance) / cosine;
}

std::string DoubtFinder::name_of(std::optional<PrimitiveId> id) const {
    return id ? primitive_name(reference_.scene(), reference_.shapes.shapes()[*id]) : "nothing";
}

template <> const World<double>& DoubtFinder::world<double>() const { return world_; }
template <> const World<Quad>& DoubtFinder::world<Quad>() const { return reference_; }

/// Traces the rays around one, farther and farther inwards until they agree with it; `meets(ray)`
/// says in a word what such a ray meets, and the doubt says where the first that disagrees is.
template <class Meets> void DoubtFinder::around(const TreeRay<double>& ray, Going going,
                                                double reach, const NoiseList& noise,
                                                const std::string& expected, Meets&& meets,
                                                std::vector<Doubt>& doubts) const {
    const Vec& d = ray.direction;
    const double off = total(noise, [&](const Noise& n) { return length(across(n.place, d)); }) +
                       16 * u_ * (largest_component(ray.origin) + reach);
    const double tilt =
        total(noise, [&](const Noise& n) { return length(across(n.way, d)); }) + 4 * u_;
    const double ulp = 2 * u_ * std::max(largest_component(ray.origin), reach);
    const auto differs = [&]<class T>(double share, T) -> std::optional<std::string> {
        const std::array<Vec, 8> sides = rim(d);
        for (std::size_t k = 0; k <= sides.size(); ++k) {
            const Vec3<T> side = vector_cast<T>(k < sides.size() ? sides[k] : Vec(0, 0, 0));
            const Vec3<T> origin = vector_cast<T>(ray.origin) + T(share * off) * side;
            const Vec3<T> way = vector_cast<T>(d) + T(share * tilt) * side;
            const std::string met = meets(Ray<T>{origin, UnitVec3<T>::of(way).vec(), T(0), going});
            if (met != expected) {
                return met;
            }
        }
        return std::nullopt;
    };
    double share = 2;  // so that no side of the rim is missed between two of the eight
    if (!differs(2 * share, double())) {
        return;  // double itself is uncertain by less than lies between there and here
    }
    std::optional<std::string> other = differs(share, Quad());
    if (!other) {
        return;
    }
    for (int k = 0; k < 12; ++k) {
        const auto nearer = differs(share / 2, Quad());
        if (!nearer) {
            break;
        }
        other = nearer;
        share /= 2;
    }
    const double ulps = share * (off + std::max(0.0, reach) * tilt) / ulp;
    doubts.push_back({"within " + ulps_text(ulps) + " of meeting " + *other +
                          (expected == "nothing" ? "" : " instead of " + expected),
                      ulps});
}

void DoubtFinder::carrying_ray(const TreeRay<double>& ray, const std::optional<LeftSurface>& from,
                               const std::optional<PrimitiveId>& met, const NoiseList& noise,
                               double path, std::vector<Doubt>& doubts) const {
    Going going = Going::unknown;
    if (from) {
        going = from->front == (ray.kind == RayKind::reflected) ? Going::outwards : Going::inwards;
    }
    const PrimitiveId leaving = from ? from->primitive : no_primitive;
    Interval<Quad> interval;
    if (ray.kind == RayKind::primary) {
        interval.from = reference_.camera.near_along(vector_cast<Quad>(ray.direction));
    }
    if (reference_.max_distance) {
        interval.to = *reference_.max_distance - Quad(path);
    }
    NoTestCount count;
    const double reach = ray.hit ? ray.hit->t : largest_component(ray.origin);
    around(
        ray, going, reach, noise, name_of(met),
        [&]<class T>(const Ray<T>& probe) {
            const auto hit =
                world<T>().shapes.closest(probe, leaving, interval_cast<T>(interval), count);
            return name_of(hit ? std::optional(hit->primitive) : std::nullopt);
        },
        doubts);
    if (ray.hit && met) {
        const double error = t_error(*met, ray, ray.hit->t, noise);
        const auto near_end = [&](Quad end) { return abs(Quad(ray.hit->t) - end) <= Quad(error); };
        if (near_end(interval.to) || (interval.from > 0 && near_end(interval.from))) {
            doubts.push_back({"within rounding of the near or the largest distance", 1});
        }
    }
}

void DoubtFinder::shadow_ray(const TreeRay<double>& ray, PrimitiveId leaving, bool front,
                             const std::optional<PrimitiveId>& blocker, ShadowMode mode,
                             const NoiseList& noise, std::vector<Doubt>& doubts) const {
    const Going going = front ? Going::outwards : Going::inwards;
    Interval<Quad> interval;
    if (ray.shadow->distance) {
        interval.to = Quad(*ray.shadow->distance) * (1 - Quad(8 * u_));
    }
    NoTestCount count;
    const double reach = ray.shadow->blocked_by
                             ? ray.shadow->blocked_by->t
                             : ray.shadow->distance.value_or(largest_component(ray.origin));
    if (mode == ShadowMode::opaque) {
        around(
            ray, going, reach, noise, name_of(blocker),
            [&]<class T>(const Ray<T>& probe) {
                const auto hit =
                    world<T>().shapes.closest(probe, leaving, interval_cast<T>(interval), count);
                return name_of(hit ? std::optional(hit->primitive) : std::nullopt);
            },
            doubts);
        return;
    }
    const auto crossed = [&]<class T>(const Ray<T>& probe) {
        std::string names;
        for (const Hit<T>& hit :
             world<T>().shapes.all(probe, leaving, interval_cast<T>(interval), count)) {
            names += (names.empty() ? "" : ", ") + name_of(hit.primitive);
        }
        return names.empty() ? std::string("nothing") : names;
    };
    const Ray<Quad> line{vector_cast<Quad>(ray.origin), vector_cast<Quad>(ray.direction), Quad(0),
                         going};
    around(ray, going, reach, noise, crossed(line), crossed, doubts);
}

void DoubtFinder::branches(const TreeRay<double>& ray, RayBounds& bounds, double speed,
                           const Settings& settings) const {
    const TreeHit<double>& hit = *ray.hit;
    if (speed <= bounds.hit.cos_incident) {
        bounds.doubts.push_back(
            {"within " + ulps_text(speed / u_ / 2) + " of meeting the other side", speed / u_ / 2});
    }
    if (hit.interface) {
        const double margin = std::abs(hit.interface->sin2_transmitted - 1);
        if (margin <= bounds.hit.sin2_transmitted) {
            bounds.doubts.push_back(
                {"within " + ulps_text(margin / u_ / 2) + " of the critical angle",
                 margin / u_ / 2});
        }
    }
    if (!(settings.min_weight > 0)) {
        return;
    }
    for (const Rgb<double>& k : {hit.kr, hit.kt}) {
        const double weight = largest_component(ray.attenuation * (k * ray.weight));
        const double error = largest_component(bounds.weight) * largest_component(k) +
                             bounds.attenuation * largest_component(k * ray.weight) +
                             4 * u_ * weight;
        const double margin = std::abs(weight - settings.min_weight);
        if (weight > 0 && margin <= error) {
            bounds.doubts.push_back({"a branch is within " + ulps_text(margin / u_ / 2 / weight) +
                                         " of the smallest weight",
                                     margin / u_ / 2 / weight});
        }
    }
}

}  // namespace raytree
