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

/// What the ray's line crosses so near to a place on it that rounding does not tell which comes
/// first: the shape at `place`, which is `except`, the start, or an end of the ray. Rays beside it
/// do not show that, for of two surfaces in one place the same one wins on all of them.
void DoubtFinder::in_depth(const TreeRay<double>& ray, Bounded place, PrimitiveId except,
                           const std::string& what, const NoiseList& noise,
                           std::vector<Doubt>& doubts) const {
    const double scale = place.value + largest_component(ray.origin);
    const double window = std::max(0x1p-20 * scale, 4 * place.error);
    const Vec3<Quad> d = vector_cast<Quad>(ray.direction);
    const Ray<Quad> line{along(vector_cast<Quad>(ray.origin), Quad(-window), d), d, Quad(0)};
    const Interval<Quad> near{Quad(place.value), Quad(place.value) + 2 * Quad(window)};
    NoTestCount count;
    for (const Hit<Quad>& hit : reference_.shapes.all(line, no_primitive, near, count)) {
        if (hit.primitive == except) {
            continue;
        }
        const auto off = static_cast<double>(abs(hit.t - Quad(window) - Quad(place.value)));
        if (off <= place.error + t_error(hit.primitive, ray, place.value, noise)) {
            const double ulps = off / (2 * u_ * scale);
            doubts.push_back(
                {"within " + ulps_text(ulps) + " of " + what + name_of(hit.primitive), ulps});
            return;
        }
    }
}

void DoubtFinder::carrying_ray(const TreeRay<double>& ray, const std::optional<LeftSurface>& from,
                               const std::optional<PrimitiveId>& met, const NoiseList& noise,
                               Bounded path, std::vector<Doubt>& doubts) const {
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
        interval.to = *reference_.max_distance - Quad(path.value);
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
    if (from) {
        in_depth(ray, {0, 0}, leaving, "starting beyond ", noise, doubts);
    }
    if (interval.from > 0) {
        const auto near = static_cast<double>(interval.from);
        in_depth(ray, {near, 8 * u_ * near}, no_primitive, "the near plane, where it crosses ",
                 noise, doubts);
    }
    Bounded place{0, 0};
    if (ray.hit && met) {
        place = {ray.hit->t, t_error(*met, ray, ray.hit->t, noise)};
        if (doubts.empty()) {
            in_depth(ray, place, *met, "meeting " + name_of(met) + " behind ", noise, doubts);
        }
    }
    if (reference_.max_distance) {
        const auto end = static_cast<double>(interval.to);
        const double error = path.error + 8 * u_ * static_cast<double>(*reference_.max_distance);
        if (end > 0 && (!ray.hit || end - place.value <= error + place.error)) {
            in_depth(ray, {end, error}, no_primitive, "the largest distance, where it crosses ",
                     noise, doubts);
        }
    }
}

/// What comes through all that is in between, in an arithmetic that has the range for it.
Rgb<Quad> DoubtFinder::through(const Ray<Quad>& ray, PrimitiveId leaving,
                               Interval<Quad> interval) const {
    NoTestCount count;
    Rgb<Quad> product(Quad(1));
    for (const Hit<Quad>& hit : reference_.shapes.all(ray, leaving, interval, count)) {
        const std::size_t object = reference_.shapes.shapes()[hit.primitive].object;
        product *= reference_.materials[reference_.scene().objects[object].material].kt;
    }
    return product;
}

void DoubtFinder::shadow_ray(const TreeRay<double>& ray, PrimitiveId leaving, bool front,
                             const std::optional<PrimitiveId>& blocker, ShadowMode mode,
                             double distance_error, const NoiseList& noise,
                             std::vector<Doubt>& doubts) const {
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
    } else {
        const auto crossed = [&]<class T>(const Ray<T>& probe) {
            std::string names;
            for (const Hit<T>& hit :
                 world<T>().shapes.all(probe, leaving, interval_cast<T>(interval), count)) {
                names += (names.empty() ? "" : ", ") + name_of(hit.primitive);
            }
            return names.empty() ? std::string("nothing") : names;
        };
        const Ray<Quad> line{vector_cast<Quad>(ray.origin), vector_cast<Quad>(ray.direction),
                             Quad(0), going};
        around(ray, going, reach, noise, crossed(line), crossed, doubts);
        if (blocker && !is_zero(through(line, leaving, interval))) {
            doubts.push_back({"within rounding of nothing coming through", 1});
        }
    }
    if (!doubts.empty()) {
        return;
    }
    in_depth(ray, {0, 0}, leaving, "starting beyond ", noise, doubts);
    if (blocker) {
        const double t = ray.shadow->blocked_by->t;
        in_depth(ray, {t, t_error(*blocker, ray, t, noise)}, *blocker,
                 "meeting " + name_of(blocker) + " behind ", noise, doubts);
    } else if (ray.shadow->distance) {
        const double end = *ray.shadow->distance;
        in_depth(ray, {end, distance_error + 16 * u_ * end}, no_primitive,
                 "the light being behind ", noise, doubts);
    }
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
            bounds.doubts.push_back({"within " + ulps_text(margin / u_ / 2 / weight) +
                                         " of the smallest weight that a branch may have",
                                     margin / u_ / 2 / weight});
        }
    }
}

}  // namespace raytree
