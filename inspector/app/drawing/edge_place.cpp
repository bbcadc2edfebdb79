#include "drawing/edge_place.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "drawing/ray_paths.h"

namespace raytree::inspector {

std::optional<EdgePlace> edge_place(const View& view, const WordBox& frame, const Point3& p) {
    const auto seen = project(view, p);
    if (seen && frame.holds({seen->x, seen->y, 0, 0})) {
        return std::nullopt;
    }
    const Point3 to = p - view.eye;
    if (glm::length(to) <= 1e-9 * glm::length(view.target - view.eye)) {
        return std::nullopt;
    }
    EdgePlace place{frame.x + frame.width / 2, frame.y + frame.height / 2, 0, 1};
    const ViewAxes axes = axes_of(view);
    double dx = glm::dot(to, axes.right), dy = -glm::dot(to, axes.up);
    if (seen) {  // the frame's middle is not the view's
        dx = seen->x - place.x;
        dy = seen->y - place.y;
    }
    if (const double length = std::hypot(dx, dy); length > 1e-9 * glm::length(to)) {
        place.dx = dx / length;
        place.dy = dy / length;
    }
    const auto way = [](double half, double d) {
        return d != 0 ? half / std::abs(d) : std::numeric_limits<double>::infinity();
    };
    const double out = std::min(way(frame.width / 2, place.dx), way(frame.height / 2, place.dy));
    place.x += out * place.dx;
    place.y += out * place.dy;
    return place;
}

std::optional<EdgePlace> edge_place(const View& view, const WordBox& frame, const Point3& p,
                                    const Point3& from) {
    const auto from_middle = edge_place(view, frame, p);
    RayPath line;
    line.from = from;
    line.to = p;
    const auto ends = on_screen(line, view);
    const auto start = project(view, from);
    if (!from_middle || !ends || !start || !frame.holds({start->x, start->y, 0, 0})) {
        return from_middle;
    }
    const double dx = ends->second.x - start->x, dy = ends->second.y - start->y;
    const double length = std::hypot(dx, dy);
    if (length < 1) {  // straight towards the viewer or away
        return from_middle;
    }
    EdgePlace place{start->x, start->y, dx / length, dy / length};
    const auto way = [](double low, double high, double at, double d) {
        return d > 0   ? (high - at) / d
               : d < 0 ? (low - at) / d
                       : std::numeric_limits<double>::infinity();
    };
    const double out = std::min(way(frame.x, frame.x + frame.width, place.x, place.dx),
                                way(frame.y, frame.y + frame.height, place.y, place.dy));
    place.x += out * place.dx;
    place.y += out * place.dy;
    return place;
}

}  // namespace raytree::inspector
