#include "trace/depth_picture.h"

#include <algorithm>
#include <cmath>

#include "trace/shading.h"

namespace raytree {
namespace {

using Side = DepthPicture::Side;
using Vec = Vec3<double>;

Side side_towards(const Vec& origin, const Vec& forward, double half) {
    const Vec other = std::abs(forward.y) < 0.9 ? Vec(0, 1, 0) : Vec(0, 0, -1);
    const Vec right = UnitVec3<double>::of(outer(forward, other)).vec();
    return {origin, right, outer(right, forward), forward, half};
}

std::vector<Vec> corners_of(const Box& box) {
    std::vector<Vec> corners;
    for (unsigned k = 0; k < 8; ++k) {
        corners.push_back({(k & 1U ? box.max : box.min).x, (k & 2U ? box.max : box.min).y,
                           (k & 4U ? box.max : box.min).z});
    }
    return corners;
}

/// How far to either side the points are, at distance 1; infinite for one that is not in front.
double half_width(const Side& side, const std::vector<Vec>& points) {
    double half = 0;
    for (const Vec& point : points) {
        const Vec from = point - side.origin;
        const double ahead = inner(from, side.forward);
        if (!(ahead > 0)) {
            return Real<double>::infinity;
        }
        half = std::max({half, std::abs(inner(from, side.right)) / ahead,
                         std::abs(inner(from, side.up)) / ahead});
    }
    return half;
}

constexpr double widest = 4;    // tan of 76 degrees: beyond it, six sides waste less
constexpr double rim = 1.0001;  // so that what lies at the border is in

std::vector<Side> sides_around(const Vec& light, const Box& bounds) {
    const Vec to_middle = bounds.center() - light;
    if (largest_component(to_middle) > 0) {
        Side side = side_towards(light, UnitVec3<double>::of(to_middle).vec(), 1);
        side.half = rim * half_width(side, corners_of(bounds));
        if (side.half <= widest) {
            return {side};
        }
    }
    std::vector<Side> sides;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double sign : {1.0, -1.0}) {
            Vec forward(0.0);
            forward[axis] = sign;
            sides.push_back(side_towards(light, forward, 1));
        }
    }
    return sides;
}

Side side_of_direction(const Vec& towards, const Box& bounds) {
    const double reach = length(bounds.size());
    Side side = side_towards(bounds.center() + reach * towards, Vec(-towards), 0);
    for (const Vec& corner : corners_of(bounds)) {
        const Vec from = corner - side.origin;
        side.half = std::max({side.half, rim * std::abs(inner(from, side.right)),
                              rim * std::abs(inner(from, side.up))});
    }
    return side;
}

Box bounds_of(const ShapeSet<double>& shapes) {
    Box bounds;
    for (std::size_t k = 0; k < shapes.size(); ++k) {
        bounds.include(shapes.bounds(static_cast<PrimitiveId>(k)));
    }
    return bounds;
}

}  // namespace

DepthPicture::DepthPicture(const World<double>& world, std::size_t light, int size) : size_(size) {
    const WorldLight<double>& from = world.lights[light];
    directional_ = from.directional;
    light_ = from.directional ? from.towards : from.position;
    const Box bounds = bounds_of(world.shapes.shapes());
    if (bounds.empty()) {
        sides_ = {side_towards(Vec(0.0), Vec(0, 0, -1), 1)};
    } else if (directional_) {
        sides_ = {side_of_direction(light_, bounds)};
    } else {
        sides_ = sides_around(light_, bounds);
    }
    NoTestCount count;
    for (std::size_t side = 0; side < sides_.size(); ++side) {
        for (int j = 0; j < size; ++j) {
            for (int i = 0; i < size; ++i) {
                const auto hit =
                    world.shapes.closest(ray_of({side, i, j}), no_primitive, {}, count);
                depths_.push_back(hit ? hit->t : Real<double>::infinity);
            }
        }
    }
}

std::size_t DepthPicture::offset(const Place& place) const {
    const auto size = static_cast<std::size_t>(size_);
    return (place.side * size + static_cast<std::size_t>(place.j)) * size +
           static_cast<std::size_t>(place.i);
}

Ray<double> DepthPicture::ray_of(const Place& place) const {
    const Side& side = sides_[place.side];
    const double x = side.half * ((2 * place.i + 1.0) / size_ - 1);
    const double y = side.half * (1 - (2 * place.j + 1.0) / size_);
    const Vec across = x * side.right + y * side.up;
    if (directional_) {
        return {side.origin + across, side.forward, 0};
    }
    return {side.origin, UnitVec3<double>::of(side.forward + across).vec(), 0};
}

DepthPicture::Place DepthPicture::place_of(const Vec3<double>& point) const {
    Place place;
    double most = -Real<double>::infinity;
    for (std::size_t k = 0; k < sides_.size(); ++k) {
        const double ahead = inner(point - sides_[k].origin, sides_[k].forward);
        if (ahead > most) {
            most = ahead;
            place.side = k;
        }
    }
    const Side& side = sides_[place.side];
    const Vec from = point - side.origin;
    const double scale = side.half * (directional_ ? 1.0 : std::max(most, 1e-300));
    const auto pixel = [&](double x) {
        const double place_in_row = std::floor((x / scale + 1) / 2 * size_);
        return static_cast<int>(std::clamp(place_in_row, 0.0, size_ - 1.0));
    };
    place.i = pixel(inner(from, side.right));
    place.j = pixel(-inner(from, side.up));
    return place;
}

double DepthPicture::distance_to(const Vec3<double>& point) const {
    return directional_ ? inner(point - sides_[0].origin, sides_[0].forward)
                        : length(Vec(point - light_));
}

DepthComparison compare(const DepthPicture& picture, const Vec3<double>& point, double bias) {
    DepthComparison comparison;
    comparison.place = picture.place_of(point);
    comparison.stored = picture.depth(comparison.place);
    comparison.distance = picture.distance_to(point);
    comparison.lit = comparison.distance <= comparison.stored + bias;
    return comparison;
}

namespace {

ShadowAnswers answers_at(const World<double>& world, std::size_t light, const DepthPicture& picture,
                         double bias, const Ray<double>& ray) {
    NoTestCount count;
    const auto hit =
        world.shapes.closest(ray, no_primitive, {world.camera.near_along(ray.direction)}, count);
    if (!hit) {
        return ShadowAnswers::none;
    }
    const SurfacePoint<double> surface =
        world.shapes.shapes().surface_at(hit->primitive, ray, hit->t);
    const bool front = inner(ray.direction, surface.geometric_normal) < 0;
    const Vec n = front ? surface.shading_normal.vec() : Vec(-surface.shading_normal.vec());
    const Illumination<double> at = illuminate(world.lights[light], surface.point, n);
    if (!at.in_front()) {
        return ShadowAnswers::none;
    }
    const Ray<double> to_light{surface.point, at.towards,
                               4 * Real<double>::unit_roundoff * largest_component(surface.point),
                               front ? Going::outwards : Going::inwards};
    const Interval<double> between{0, at.distance * (1 - 8 * Real<double>::unit_roundoff)};
    const bool reached = !world.shapes.any(to_light, hit->primitive, between, count);
    const bool lit = compare(picture, surface.point, bias).lit;
    return reached ? (lit ? ShadowAnswers::both_lit : ShadowAnswers::wrongly_dark)
                   : (lit ? ShadowAnswers::wrongly_lit : ShadowAnswers::both_dark);
}

}  // namespace

std::vector<ShadowAnswers> shadow_answers(const World<double>& world, std::size_t light,
                                          const DepthPicture& picture, double bias) {
    std::vector<ShadowAnswers> answers;
    const Camera& camera = world.scene().camera;
    for (int j = 0; j < camera.height; ++j) {
        for (int i = 0; i < camera.width; ++i) {
            answers.push_back(answers_at(world, light, picture, bias, world.camera.primary(i, j)));
        }
    }
    return answers;
}

DepthAgreement agreement(const World<double>& world, std::size_t light, const DepthPicture& picture,
                         double bias) {
    const std::vector<ShadowAnswers> answers = shadow_answers(world, light, picture, bias);
    const auto count = [&](ShadowAnswers answer) {
        return static_cast<std::size_t>(std::ranges::count(answers, answer));
    };
    return {answers.size() - count(ShadowAnswers::none), count(ShadowAnswers::wrongly_dark),
            count(ShadowAnswers::wrongly_lit)};
}

}  // namespace raytree
