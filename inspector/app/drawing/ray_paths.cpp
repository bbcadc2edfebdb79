#include "drawing/ray_paths.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace raytree::inspector {
namespace {

/// An escaped ray is drawn a quarter of the scene long.
constexpr double escaped_length = 0.25;
/// A light farther away than this is not drawn at its place; rays to it fade like escaped ones.
constexpr double far_away = 3;

RayPath shadow_path(const PixelTree& tree, const TreeRay<double>& ray, const Extent& extent) {
    RayPath path{ray.id, look_of(ray), ray.origin, {}, weight_of(tree, ray), RayPath::End::light,
                 false};
    double length = 0;
    if (ray.shadow->blocked_by) {
        path.end = RayPath::End::blocked;
        length = ray.shadow->blocked_by->t;
    } else {
        const bool far =
            !ray.shadow->distance || *ray.shadow->distance > far_away * extent.diagonal;
        length = far ? 1.6 * escaped_length * extent.diagonal : *ray.shadow->distance;
        path.fades = far;
    }
    path.to = along(ray.origin, length, ray.direction);
    return path;
}

RayPath path_of(const PixelTree& tree, const TreeRay<double>& ray, const Extent& extent) {
    if (ray.shadow) {
        return shadow_path(tree, ray, extent);
    }
    RayPath path{ray.id, look_of(ray), ray.origin, {}, weight_of(tree, ray), RayPath::End::hit,
                 false};
    if (ray.hit) {
        path.to = ray.hit->point;
        return path;
    }
    // A primary ray starts at the eye, outside the scene: it is to be seen passing it.
    const double length = ray.kind == RayKind::primary
                              ? extent.far_distance + escaped_length * extent.diagonal
                              : escaped_length * extent.diagonal;
    path.to = along(ray.origin, length, ray.direction);
    path.end = RayPath::End::open;
    path.fades = true;
    return path;
}

double distance_to_segment(double x, double y, const ScreenPoint& a, const ScreenPoint& b) {
    const double dx = b.x - a.x, dy = b.y - a.y;
    const double length2 = dx * dx + dy * dy;
    const double s =
        length2 > 0 ? std::clamp(((x - a.x) * dx + (y - a.y) * dy) / length2, 0.0, 1.0) : 0;
    return std::hypot(x - a.x - s * dx, y - a.y - s * dy);
}

}  // namespace

std::vector<RayPath> ray_paths(const PixelTree& tree, const Extent& extent, const RayFilter& filter,
                               std::size_t most) {
    std::vector<const TreeRay<double>*> rays;
    for (const TreeRay<double>& ray : tree.tree.rays) {
        if (filter.empty() || shown(filter, tree, ray) != Shown::hidden) {
            rays.push_back(&ray);
        }
    }
    if (rays.size() > most) {
        const auto heavier = [&](const TreeRay<double>* a, const TreeRay<double>* b) {
            const double x = weight_of(tree, *a), y = weight_of(tree, *b);
            return x != y ? x > y : a->id < b->id;
        };
        std::nth_element(rays.begin(), rays.begin() + static_cast<std::ptrdiff_t>(most), rays.end(),
                         heavier);
        rays.resize(most);
        std::ranges::sort(rays, {}, [](const TreeRay<double>* ray) { return ray->id; });
    }
    std::vector<RayPath> paths;
    paths.reserve(rays.size());
    for (const TreeRay<double>* const ray : rays) {
        paths.push_back(path_of(tree, *ray, extent));
        paths.back().graft = !tree.is_own(ray->id);
    }
    return paths;
}

std::optional<std::pair<ScreenPoint, ScreenPoint>> on_screen(const RayPath& path,
                                                             const View& view) {
    Point3 from = path.from, to = path.to;
    const Point3 forward = axes_of(view).forward;
    const double least = 2e-3 * glm::length(view.target - view.eye);
    const double a = glm::dot(from - view.eye, forward), b = glm::dot(to - view.eye, forward);
    if (a < least && b < least) {
        return std::nullopt;
    }
    if (a < least) {
        from += (to - from) * ((least - a) / (b - a));
    } else if (b < least) {
        to += (from - to) * ((least - b) / (a - b));
    }
    const auto first = project(view, from), second = project(view, to);
    return first && second ? std::optional(std::pair(*first, *second)) : std::nullopt;
}

std::optional<std::size_t> path_at(const std::vector<RayPath>& paths, const View& view, double x,
                                   double y, double reach) {
    std::optional<std::size_t> found;
    double best = reach;
    for (std::size_t k = 0; k < paths.size(); ++k) {
        const auto ends = on_screen(paths[k], view);
        if (!ends) {
            continue;
        }
        const double distance = distance_to_segment(x, y, ends->first, ends->second);
        if (distance < best) {
            best = distance;
            found = k;
        }
    }
    return found;
}

std::vector<Point3> points_of(const std::vector<RayPath>& paths, const Extent& extent) {
    std::vector<Point3> points;
    for (const RayPath& path : paths) {
        points.push_back(path.from);
        const double length = glm::length(path.to - path.from);
        const double most = std::max(1.2 * extent.diagonal, 1.0 * extent.far_distance);
        points.push_back(length <= most ? path.to
                                        : path.from + (path.to - path.from) * (most / length));
    }
    return points;
}

}  // namespace raytree::inspector
