#include "drawing/coverage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace raytree::inspector {
namespace {

constexpr double cell = 6;  // pixels

}  // namespace

Coverage::Coverage(const View& view)
    : eye_(view.eye),
      axes_(axes_of(view)),
      scale_(1 / (cell * length_per_pixel(view, view.eye + axes_.forward))),
      nearest_(1e-3 * glm::length(view.target - view.eye)),
      columns_(static_cast<int>(std::ceil(view.width / cell))),
      rows_(static_cast<int>(std::ceil(view.height / cell))),
      cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

Coverage::Corner Coverage::corner(const Point3& p) const {
    const Point3 to = p - eye_;
    return {glm::dot(to, axes_.right), -glm::dot(to, axes_.up), glm::dot(to, axes_.forward)};
}

Coverage::Place Coverage::place(const Corner& c) const {
    const double by = scale_ / std::max(c.depth, nearest_);
    return {columns_ / 2.0 + c.x * by, rows_ / 2.0 + c.y * by};
}

void Coverage::add(const Mesh& mesh) {
    std::vector<Corner> corners;
    corners.reserve(mesh.points.size() / 3);
    for (std::size_t k = 0; k + 2 < mesh.points.size(); k += 3) {
        corners.push_back(corner({mesh.points[k], mesh.points[k + 1], mesh.points[k + 2]}));
    }
    const auto at = [&](std::size_t k) -> const Corner& {
        return corners[static_cast<std::size_t>(mesh.triangles[k])];
    };
    for (std::size_t k = 0; k + 2 < mesh.triangles.size(); k += 3) {
        add_triangle(at(k), at(k + 1), at(k + 2));
    }
}

/// Where the line from one to the other is this deep.
Coverage::Corner Coverage::between(const Corner& from, const Corner& to, double depth) {
    const double s = (depth - from.depth) / (to.depth - from.depth);
    return {from.x + s * (to.x - from.x), from.y + s * (to.y - from.y), depth};
}

/// Of a thin triangle, the cells along its longest side; of another one, the box around it.
void Coverage::add_triangle(const Corner& a, const Corner& b, const Corner& c) {
    const double depth = std::max({a.depth, b.depth, c.depth});
    if (depth < nearest_) {
        return;
    }
    const std::array<Corner, 3> corners = {a, b, c};
    std::array<Place, 3> p;
    for (std::size_t k = 0; k < 3; ++k) {
        // What lies behind the eye is drawn in along the side that comes from farthest away.
        const Corner& far = *std::ranges::max_element(corners, {}, &Corner::depth);
        p[k] = place(corners[k].depth < nearest_ ? between(corners[k], far, nearest_) : corners[k]);
    }
    const auto [left, right] = std::minmax({p[0].x, p[1].x, p[2].x});
    const auto [top, bottom] = std::minmax({p[0].y, p[1].y, p[2].y});
    constexpr double small = 2;  // cells
    if (right - left < small && bottom - top < small) {
        mark_box(left, top, right, bottom, depth);
        return;
    }
    const double twice_area =
        std::abs((p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (p[1].y - p[0].y));
    const auto length = [&](std::size_t k) {
        return std::hypot(p[k].x - p[(k + 1) % 3].x, p[k].y - p[(k + 1) % 3].y);
    };
    std::size_t longest = 0;
    for (const std::size_t k : {1U, 2U}) {
        longest = length(k) > length(longest) ? k : longest;
    }
    if (twice_area < 0.7 * length(longest)) {
        mark_line(p[longest], p[(longest + 1) % 3], depth);
    } else {
        mark_box(left, top, right, bottom, depth);
    }
}

/// The line's cells and those beside them.
void Coverage::mark_line(Place from, Place to, double depth) {
    const Place way{to.x - from.x, to.y - from.y};
    // Only where it crosses the screen (Liang & Barsky 1984).
    double first = 0, last = 1;
    const auto keep = [&](double towards, double room) {
        if (towards < 0) {
            first = std::max(first, room / towards);
        } else if (towards > 0) {
            last = std::min(last, room / towards);
        } else if (room < 0) {
            last = -1;
        }
    };
    keep(-way.x, from.x + 1);
    keep(way.x, columns_ + 1 - from.x);
    keep(-way.y, from.y + 1);
    keep(way.y, rows_ + 1 - from.y);
    const int steps =
        static_cast<int>(2 * std::max(0.0, last - first) * std::hypot(way.x, way.y)) + 1;
    for (int k = 0; k <= steps && first <= last; ++k) {
        const double s = first + (last - first) * k / steps;
        const double x = from.x + s * way.x, y = from.y + s * way.y;
        mark_box(x - 0.5, y - 0.5, x + 0.5, y + 0.5, depth);
    }
}

void Coverage::mark_box(double left, double top, double right, double bottom, double depth) {
    // A float that is no smaller.
    const float far = std::nextafter(static_cast<float>(depth), INFINITY);
    const int l = static_cast<int>(std::max(0.0, std::floor(left - 0.25)));
    const int r = static_cast<int>(std::min(columns_ - 1.0, std::floor(right + 0.25)));
    const int b = static_cast<int>(std::min(rows_ - 1.0, std::floor(bottom + 0.25)));
    for (int j = static_cast<int>(std::max(0.0, std::floor(top - 0.25))); j <= b; ++j) {
        for (int i = l; i <= r; ++i) {
            float& cell = cells_[static_cast<std::size_t>(j * columns_ + i)];
            cell = std::max(cell, far);
        }
    }
}

bool Coverage::is_behind(const Point3& centre, double radius) const {
    const Corner at = corner(centre);
    const double near = at.depth - radius;
    if (near < nearest_) {
        return at.depth + radius > nearest_;
    }
    const Place p = place(at);
    const double reach = radius * scale_ / near;
    const int l = static_cast<int>(std::max(0.0, std::floor(p.x - reach)));
    const int r = static_cast<int>(std::min(columns_ - 1.0, std::floor(p.x + reach)));
    const int b = static_cast<int>(std::min(rows_ - 1.0, std::floor(p.y + reach)));
    for (int j = static_cast<int>(std::max(0.0, std::floor(p.y - reach))); j <= b; ++j) {
        for (int i = l; i <= r; ++i) {
            if (static_cast<double>(cells_[static_cast<std::size_t>(j * columns_ + i)]) >= near) {
                return true;
            }
        }
    }
    return false;
}

}  // namespace raytree::inspector
