#include "drawing/picking.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "drawing/ray_mesh.h"

namespace raytree::inspector {

std::optional<Thing> light_at(const Scene& scene, const Extent& extent, const View& view, double x,
                              double y, double reach) {
    std::optional<Thing> found;
    for (std::size_t k = 0; k < scene.lights.size(); ++k) {
        const auto at = project(view, place_of(scene.lights[k], extent));
        const double distance = at ? std::hypot(at->x - x, at->y - y) : reach;
        if (distance < reach) {
            reach = distance;
            found = Thing{Thing::Kind::light, k};
        }
    }
    return found;
}

namespace {

/// What a line of sight meets first.
struct Sight {
    Thing object;
    Point3 at;
};

std::optional<Sight> sight_along(const Document& document, const View& view,
                                 const Point3& direction) {
    const auto& shapes = document.world().shapes;
    const double cut = view.cut / glm::dot(direction, axes_of(view).forward);
    const Ray<double> ray{view.eye + direction * cut, direction, 0};
    NoTestCount count;
    const auto hit = shapes.closest(ray, no_primitive, {}, count);
    if (!hit) {
        return std::nullopt;
    }
    return Sight{{Thing::Kind::object, shapes.shapes()[hit->primitive].object},
                 ray.origin + direction * hit->t};
}

std::optional<Sight> sight_of(const Document& document, const View& view, double x, double y) {
    return sight_along(document, view, direction_through(view, x, y));
}

}  // namespace

std::optional<Thing> object_at(const Document& document, const View& view, double x, double y) {
    const auto sight = sight_of(document, view, x, y);
    return sight ? std::optional(sight->object) : std::nullopt;
}

bool is_hidden(const Document& document, const View& view, const Point3& p) {
    constexpr double on_it = 1e-3;  // of the distance: the point may lie on what is met
    const double distance = glm::length(p - view.eye);
    if (!(distance > 0)) {
        return false;
    }
    const auto sight = sight_along(document, view, (p - view.eye) / distance);
    return sight && glm::length(sight->at - view.eye) < (1 - on_it) * distance;
}

std::optional<Point3> seen_point(const Document& document, const View& view, Thing object) {
    constexpr int half = 5;  // of the grid's places to each side
    for (int ring = 0; ring <= half; ++ring) {
        for (int row = -ring; row <= ring; ++row) {
            for (int column = -ring; column <= ring; ++column) {
                if (std::max(std::abs(row), std::abs(column)) != ring) {
                    continue;
                }
                const auto sight = sight_of(document, view, view.width * (0.5 + 0.09 * column),
                                            view.height * (0.5 + 0.09 * row));
                if (sight && sight->object == object) {
                    return sight->at;
                }
            }
        }
    }
    return std::nullopt;
}

std::vector<Point3> corners_of(const Document& document, const Extent& extent, Thing thing) {
    if (thing.kind == Thing::Kind::light) {
        const Point3 at = place_of(document.scene().lights[thing.index], extent);
        const auto corners = Span3{at, at}.grown(0.06 * extent.diagonal).corners();
        return {corners.begin(), corners.end()};
    }
    const auto& shapes = document.world().shapes.shapes();
    std::optional<Span3> box;
    for (PrimitiveId id = 0; id < shapes.size(); ++id) {
        if (shapes[id].object == thing.index) {
            const Box bounds = shapes.bounds(id);
            if (!box) {
                box = Span3{bounds.min, bounds.max};
            }
            box->add(bounds.min);
            box->add(bounds.max);
        }
    }
    // Of a floor that goes on for ever, what is seen.
    const Span3 room = extent.seen.grown(0.3 * extent.diagonal);
    std::vector<Point3> points;
    if (box) {
        for (Point3 corner : box->corners()) {
            points.push_back(glm::clamp(corner, room.low, room.high));
        }
    }
    return points;
}

}  // namespace raytree::inspector
