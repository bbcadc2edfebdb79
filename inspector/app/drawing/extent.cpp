#include "drawing/extent.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <vector>

namespace raytree::inspector {
namespace {

constexpr int grid = 24;

struct Seen {
    std::vector<Point3> points;
    std::vector<double> depths;  ///< along the line of sight
};

Seen look_around(const Document& document) {
    const World<double>& world = document.world();
    const Camera& camera = world.scene().camera;
    const Point3 forward = world.camera.forward();
    Seen seen;
    NoTestCount count;
    for (int y = 0; y < grid; ++y) {
        for (int x = 0; x < grid; ++x) {
            const auto ray = world.camera.primary((2 * x + 1) * camera.width / (2 * grid),
                                                  (2 * y + 1) * camera.height / (2 * grid));
            const auto hit = world.shapes.closest(ray, no_primitive,
                                                  {world.camera.near_along(ray.direction)}, count);
            if (hit) {
                seen.points.push_back(along(ray.origin, hit->t, ray.direction));
                seen.depths.push_back(hit->t * glm::dot(ray.direction, forward));
            }
        }
    }
    return seen;
}

template <class T> T quantile(std::vector<T> values, double share) {
    const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + place, values.end());
    return values[static_cast<std::size_t>(place)];
}

/// How far what is seen reaches along the line of sight. A floor's far end does not count, things
/// do that stand far behind others: they lie beyond a gap and take a good part of the picture.
double reach_of(const Seen& seen) {
    constexpr double usual = 3;  // times the depth in the middle
    constexpr double gap = 1.5, part = 0.2;
    std::vector<double> depths = seen.depths;
    std::ranges::sort(depths);
    const double reach = usual * quantile(depths, 0.5);
    const auto beyond = std::ranges::upper_bound(depths, reach);
    const auto count = static_cast<double>(depths.end() - beyond);
    if (count < part * static_cast<double>(depths.size()) || *beyond < gap * *(beyond - 1)) {
        return reach;
    }
    return usual * *(beyond + (depths.end() - beyond) / 2);
}

/// The box of the points but for a few outliers.
Span3 bulk_of(const Seen& seen, double farthest) {
    Span3 box;
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double> values;
        for (std::size_t k = 0; k < seen.points.size(); ++k) {
            if (seen.depths[k] <= farthest) {
                values.push_back(seen.points[k][axis]);
            }
        }
        box.low[axis] = quantile(values, 0.03);
        box.high[axis] = quantile(values, 0.97);
    }
    return box;
}

/// Shapes that stand in the midst of what is seen count with all of their size. Very many are small
/// and close together: some of them tell as much.
void add_shapes(const World<double>& world, Span3& seen) {
    constexpr std::size_t most = 50'000;  // that are looked at
    const double size = seen.diagonal();
    const Span3 around = seen.grown(0.25 * size);
    const std::size_t count = world.shapes.shapes().size();
    const std::size_t step = 1 + count / most;
    for (std::size_t k = 0; k < count; k += step) {
        const auto id = static_cast<PrimitiveId>(k);
        const Box bounds = world.shapes.shapes().bounds(id);
        const Span3 box{bounds.min, bounds.max};
        if (box.diagonal() <= 1.2 * size && around.contains(box.centre())) {
            seen.add(box.low);
            seen.add(box.high);
        }
    }
}

}  // namespace

void Span3::add(const Point3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
}

bool Span3::contains(const Point3& p) const { return p == glm::clamp(p, low, high); }

Span3 Span3::grown(double by) const { return {low - Point3(by), high + Point3(by)}; }

std::array<Point3, 8> Span3::corners() const {
    std::array<Point3, 8> all;
    for (std::size_t k = 0; k < 8; ++k) {
        all[k] = {k & 1 ? high.x : low.x, k & 2 ? high.y : low.y, k & 4 ? high.z : low.z};
    }
    return all;
}

Extent extent_of(const Document& document) {
    const Camera& camera = document.scene().camera;
    const Seen seen = look_around(document);
    Extent extent;
    if (seen.points.empty()) {
        const double distance = length(camera.look_at - camera.eye);
        extent.seen = Span3{camera.look_at, camera.look_at}.grown(0.4 * distance);
        extent.diagonal = extent.seen.diagonal();
        extent.plane_distance = 0.4 * distance;
        extent.far_distance = 1.4 * distance;
        return extent;
    }
    const double middle = quantile(seen.depths, 0.5), nearest = quantile(seen.depths, 0);
    const double reach = reach_of(seen);
    extent.seen = bulk_of(seen, reach);
    if (!(extent.seen.diagonal() > 0)) {
        extent.seen = extent.seen.grown(0.1 * middle);
    }
    add_shapes(document.world(), extent.seen);
    extent.diagonal = extent.seen.diagonal();
    extent.plane_distance = std::max(std::min(0.34 * middle, 0.7 * nearest), 0.05 * middle);
    extent.far_distance = std::min(quantile(seen.depths, 0.9), 2 * reach / 3);
    return extent;
}

std::array<Point3, 4> picture_corners(const Document& document, double distance) {
    const CameraRays<double>& rays = document.world().camera;
    const Scene& scene = document.scene();
    const int w = scene.camera.width, h = scene.camera.height;
    // Pixels are sampled in their middle or in their corner: their edges lie half a pixel off.
    const double half = scene.settings.pixel_sample == PixelSample::center ? 0.5 : 0;
    const double pixel_w = rays.xp(1) - rays.xp(0), pixel_h = rays.yp(0) - rays.yp(1);
    const double left = rays.xp(0) - half * pixel_w, right = left + w * pixel_w;
    const double top = rays.yp(0) + half * pixel_h, bottom = top - h * pixel_h;
    const auto corner = [&](double x, double y) {
        return scene.camera.eye +
               distance * (rays.forward().vec() + x * rays.right().vec() + y * rays.up());
    };
    return {corner(left, top), corner(right, top), corner(right, bottom), corner(left, bottom)};
}

Point3 place_on_picture(const Document& document, Pixel pixel, double distance) {
    const CameraRays<double>& rays = document.world().camera;
    return document.scene().camera.eye +
           distance * (rays.forward().vec() + rays.xp(pixel.i) * rays.right().vec() +
                       rays.yp(pixel.j) * rays.up());
}

}  // namespace raytree::inspector
