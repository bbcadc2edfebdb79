#include "drawing/picking.h"

#include <cmath>
#include <glm/common.hpp>

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

std::optional<Thing> object_at(const Document& document, const View& view, double x, double y) {
    const auto& shapes = document.world().shapes;
    const Ray<double> ray{view.eye, direction_through(view, x, y), 0};
    NoTestCount count;
    const auto hit = shapes.closest(ray, no_primitive, {}, count);
    return hit ? std::optional(Thing{Thing::Kind::object, shapes.shapes()[hit->primitive].object})
               : std::nullopt;
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
