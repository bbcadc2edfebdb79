#include "drawing/standard_views.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "drawing/picking.h"
#include "drawing/ray_mesh.h"

namespace raytree::inspector {
namespace {

constexpr double fov = 30;     // of all views but the camera's
constexpr double near = 0.95;  // of the diagonal: what is farther off may lie outside the view

/// The legend's strip, unless it would leave too little of the view.
int strip_of(const View& view) { return std::min(view.foot, view.height / 4); }

// What is seen whole is no larger, of the diagonal; what is not flat, as floors are, may be.
constexpr double largest = 0.6, largest_thick = 1.6;

bool is_thick(const Span3& box) {
    const Point3 size = box.high - box.low;
    return std::min({size.x, size.y, size.z}) > 0.2 * std::max({size.x, size.y, size.z});
}

void add_corners(std::vector<Point3>& points, const Span3& box) {
    const auto corners = box.corners();
    points.insert(points.end(), corners.begin(), corners.end());
}

/// Things that stand in the midst of what is seen are seen whole; floors and walls are larger. Very
/// many are small and close together: some of them tell as much.
void add_shapes_seen(std::vector<Point3>& points, const Document& document, const Extent& extent) {
    constexpr std::size_t most = 20'000;  // that are looked at
    const auto& shapes = document.world().shapes.shapes();
    for (std::size_t k = 0; k < shapes.size(); k += 1 + shapes.size() / most) {
        const Box bounds = shapes.bounds(static_cast<PrimitiveId>(k));
        const Span3 box{bounds.min, bounds.max};
        if (box.diagonal() < largest * extent.diagonal && extent.seen.contains(box.centre())) {
            add_corners(points, box);
        }
    }
}

/// Shapes at which rays end, where they are not larger than what is seen. Of very many shapes none
/// is as large as that it would matter.
void add_shapes_met(std::vector<Point3>& points, const Document& document, const Extent& extent,
                    const std::vector<RayPath>& paths) {
    constexpr std::size_t most_shapes = 50'000, most_pairs = 2'000'000;  // that are looked at
    const auto& shapes = document.world().shapes.shapes();
    if (shapes.size() > most_shapes || shapes.size() * paths.size() > most_pairs) {
        return;
    }
    for (PrimitiveId id = 0; id < shapes.size(); ++id) {
        const Box bounds = shapes.bounds(id);
        const Span3 box{bounds.min, bounds.max};
        const Span3 around = box.grown(1e-3 * extent.diagonal);
        if (box.diagonal() < (is_thick(box) ? largest_thick : largest) * extent.diagonal &&
            glm::length(box.centre() - extent.seen.centre()) < near * extent.diagonal &&
            std::ranges::any_of(paths, [&](const RayPath& path) {
                return path.end == RayPath::End::hit && around.contains(path.to);
            })) {
            add_corners(points, box);
        }
    }
}

/// What the view from the side is to contain: what is far off does not make all the rest small.
std::vector<Point3> side_points(const Document& document, const Extent& extent,
                                const std::vector<RayPath>& paths) {
    const Point3 middle = extent.seen.centre();
    std::vector<Point3> points = points_of(paths, extent);
    std::erase_if(
        points, [&](const Point3& p) { return glm::length(p - middle) > near * extent.diagonal; });
    add_shapes_met(points, document, extent, paths);
    add_shapes_seen(points, document, extent);
    for (const Point3& corner : picture_corners(document, extent.plane_distance)) {
        points.push_back(corner);
    }
    for (const Point3& corner : extent.seen.corners()) {
        points.push_back((corner + middle) * 0.5);
    }
    for (const Light& light : document.scene().lights) {
        if (std::holds_alternative<DirectionalLight>(light.kind)) {
            points.push_back(place_of(light, extent));
        }
    }
    points.push_back(document.scene().camera.eye);
    return points;
}

}  // namespace

View camera_view(const Document& document, const Extent& extent, const View& now) {
    const CameraRays<double>& camera = document.world().camera;
    View view = now;
    view.eye = document.scene().camera.eye;
    view.target = view.eye + camera.forward().vec() * extent.far_distance;
    view.up = camera.up();
    view.cut = 0;
    double high = 0, wide = 0;
    for (const Point3& corner : picture_corners(document, 1)) {
        high = std::max(high, std::abs(glm::dot(corner - view.eye, camera.up())));
        wide = std::max(wide, std::abs(glm::dot(corner - view.eye, camera.right().vec())));
    }
    const double shape = static_cast<double>(view.width) / std::max(1, view.height);
    constexpr double margin = 1.06;
    // The picture stays in the middle, as the camera sees it: the strip is left free at the top
    // too.
    const double free = 1 - 2.0 * strip_of(view) / std::max(1, view.height);
    view.fov_degrees =
        2 * std::atan(margin * std::max(high / free, wide / shape)) * 180 / std::numbers::pi;
    return view;
}

View side_view(const Document& document, const Extent& extent, const std::vector<RayPath>& paths,
               const View& now) {
    const CameraRays<double>& camera = document.world().camera;
    View view = now;
    view.up = glm::normalize(document.scene().camera.up);
    view.target = extent.seen.centre();
    view.eye = view.target + extent.diagonal * (0.9 * camera.right().vec() -
                                                0.72 * camera.forward().vec() + 0.42 * view.up);
    return fitted_above_legend(view, side_points(document, extent, paths));
}

View hit_view(const Document& document, const TreeRay<double>& ray, const Extent& extent,
              const View& now) {
    constexpr double least = 0.03, most = 0.22;  // of the diagonal
    double size = most * extent.diagonal;
    if (const auto thing = object_named(document.scene(), ray.hit->object)) {
        Span3 box{ray.hit->point, ray.hit->point};
        for (const Point3& corner : corners_of(document, extent, *thing)) {
            box.add(corner);
        }
        size = 0.65 * box.diagonal();
    }
    const double half_height = std::clamp(size, least * extent.diagonal, most * extent.diagonal);
    const Point3 d = ray.direction;
    const Point3 normal = glm::dot(ray.hit->normal, d) > 0 ? -ray.hit->normal : ray.hit->normal;
    const Point3 sideways = d - glm::dot(d, normal) * normal;
    const double length = glm::length(sideways);
    const Point3 forward = length > 1e-9 ? glm::cross(normal, sideways / length) : across(normal).u;
    View view = now;
    view.fov_degrees = fov;
    view.up = normal;
    view.target = ray.hit->point;
    view.cut = half_height / std::tan(fov * std::numbers::pi / 360);
    view.eye = view.target - forward * view.cut;
    return view;
}

/// Fitted into a view that is lower by the legend, which is then put back at its lower edge.
View fitted_above_legend(const View& now, std::span<const Point3> points, double margin) {
    const int strip = strip_of(now);
    View view = now;
    view.height -= strip;
    view.fov_degrees = fov * view.height / now.height;
    view = fitted(view, points, margin);
    view.height = now.height;
    view.fov_degrees = fov;
    return panned(view, 0, strip / 2.0);
}

}  // namespace raytree::inspector
