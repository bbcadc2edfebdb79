#include "drawing/ground.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "drawing/mesh.h"
#include "drawing/polygon_fill.h"

namespace raytree::inspector {
namespace {

constexpr double firm_to = 0.4, rim = 0.9;  // of the diagonal, from the scene's middle
constexpr double cell = 0.1;                // of the grid, of the diagonal
constexpr int rim_corners = 72;

/// Halves the longest side until all are short enough.
void halve(const Ground::Triangle& triangle, double most, std::vector<Ground::Triangle>& out) {
    const auto& [a, b, c] = triangle;
    const double ab = glm::length(b - a), bc = glm::length(c - b), ca = glm::length(a - c);
    if (std::max({ab, bc, ca}) <= most) {
        out.push_back(triangle);
    } else if (ab >= bc && ab >= ca) {
        halve({a, (a + b) * 0.5, c}, most, out);
        halve({(a + b) * 0.5, b, c}, most, out);
    } else {
        halve({b, c, a}, most, out);
    }
}

/// The part of a line within a convex outline whose normal is given (Cyrus & Beck 1978).
std::vector<Ground::Segment> within(const std::vector<Point3>& outline, const Point3& normal,
                                    const Point3& at, const Point3& way) {
    constexpr double endless = 1e300;
    double first = -endless, last = endless;
    for (std::size_t k = 0; k < outline.size(); ++k) {
        const Point3& a = outline[k];
        const Point3 inwards = glm::cross(normal, outline[(k + 1) % outline.size()] - a);
        const double speed = glm::dot(inwards, way), room = glm::dot(inwards, a - at);
        if (speed > 0) {
            first = std::max(first, room / speed);
        } else if (speed < 0) {
            last = std::min(last, room / speed);
        } else if (room > 0) {
            return {};
        }
    }
    const bool ends = first > -endless && last < endless;
    return ends && first < last
               ? std::vector<Ground::Segment>{{{at + way * first, at + way * last}}}
               : std::vector<Ground::Segment>();
}

}  // namespace

Ground::Ground(const Extent& extent) : middle_(extent.seen.centre()), diagonal_(extent.diagonal) {}

double Ground::firmness(const Point3& p) const {
    const double distance = glm::length(p - middle_) / diagonal_;
    const double s = std::clamp((rim - distance) / (rim - firm_to), 0.0, 1.0);
    return s * s * (3 - 2 * s);
}

bool Ground::is_firm(const Triangle& triangle) const {
    return std::ranges::all_of(triangle, [&](const Point3& p) { return firmness(p) == 1; });
}

std::vector<Ground::Triangle> Ground::facets(const Triangle& triangle, const Point3& normal) const {
    const double away = glm::dot(triangle[0] - middle_, normal);
    const double radius2 = rim * rim * diagonal_ * diagonal_ - away * away;
    std::vector<Triangle> parts;
    if (!(radius2 > 0)) {
        return parts;
    }
    std::vector<Point3> outline(triangle.begin(), triangle.end());
    const Across axes = across(normal);
    for (int k = 0; k < rim_corners && !outline.empty(); ++k) {
        const double angle = 2 * std::numbers::pi * k / rim_corners;
        const Point3 out = std::cos(angle) * axes.u + std::sin(angle) * axes.v;
        outline = clipped(outline, out, glm::dot(out, middle_) + std::sqrt(radius2));
    }
    for (std::size_t k = 1; k + 1 < outline.size(); ++k) {
        halve({outline[0], outline[k], outline[k + 1]}, finest(), parts);
    }
    return parts;
}

std::vector<Ground::Segment> Ground::pieces(const Point3& from, const Point3& to) const {
    const Point3 way = to - from, off = from - middle_;
    const double radius = rim * diagonal_;
    // |off + s way|^2 = radius^2
    const double a = glm::dot(way, way), b = glm::dot(way, off);
    const double root2 = b * b - a * (glm::dot(off, off) - radius * radius);
    std::vector<Segment> parts;
    if (!(a > 0) || !(root2 > 0)) {
        return parts;
    }
    const double first = std::max(0.0, (-b - std::sqrt(root2)) / a);
    const double last = std::min(1.0, (-b + std::sqrt(root2)) / a);
    const int count = static_cast<int>(std::ceil((last - first) * std::sqrt(a) / finest()));
    for (int k = 0; k < count; ++k) {
        const auto at = [&](int piece) {
            return from + way * (first + (last - first) * piece / count);
        };
        parts.push_back({at(k), at(k + 1)});
    }
    return parts;
}

std::vector<Ground::Segment> Ground::grid(const Triangle& triangle, const Point3& normal) const {
    // Turned so that the corners go round the normal.
    std::vector<Point3> outline(triangle.begin(), triangle.end());
    if (glm::dot(glm::cross(outline[1] - outline[0], outline[2] - outline[0]), normal) < 0) {
        std::swap(outline[1], outline[2]);
    }
    const Across axes = across(normal);
    const Point3 origin = middle_ + normal * glm::dot(triangle[0] - middle_, normal);
    const int most = static_cast<int>(rim / cell) + 1;
    std::vector<Segment> parts;
    for (int k = -most; k <= most; ++k) {
        for (const auto& [way, aside] : {std::pair(axes.u, axes.v), std::pair(axes.v, axes.u)}) {
            const Point3 at = origin + aside * (k * cell * diagonal_);
            for (const auto& [from, to] : within(outline, normal, at, way)) {
                const auto drawn = pieces(from, to);
                parts.insert(parts.end(), drawn.begin(), drawn.end());
            }
        }
    }
    return parts;
}

}  // namespace raytree::inspector
