#include "formats/split_polygon.h"

#include <array>
#include <cstddef>
#include <numeric>
#include <span>

#include "scene/planarity.h"

namespace raytree {
namespace {

/// A polygon's vertices as seen along its normal: `turn` is positive counter-clockwise.
class Outline {
  public:
    Outline(const std::vector<Point>& vertices, const Point& normal)
        : vertices_(vertices), normal_(normal) {}

    double turn(std::size_t a, std::size_t b, std::size_t c) const {
        const Point& corner = vertices_[b];
        return inner(normal_, outer(corner - vertices_[a], vertices_[c] - corner));
    }
    bool covers(const std::array<std::size_t, 3>& ear, std::size_t vertex) const {
        return turn(ear[0], ear[1], vertex) >= 0 && turn(ear[1], ear[2], vertex) >= 0 &&
               turn(ear[2], ear[0], vertex) >= 0;
    }
    /// Whether the triangle at the corner `at` of what is left lies inside it.
    bool is_ear(const std::vector<std::size_t>& left, std::size_t at) const;

  private:
    const std::vector<Point>& vertices_;
    const Point& normal_;
};

std::array<std::size_t, 3> corner(const std::vector<std::size_t>& left, std::size_t at) {
    const std::size_t count = left.size();
    return {left[(at + count - 1) % count], left[at], left[(at + 1) % count]};
}

bool Outline::is_ear(const std::vector<std::size_t>& left, std::size_t at) const {
    const auto ear = corner(left, at);
    if (!(turn(ear[0], ear[1], ear[2]) > 0)) {
        return false;
    }
    for (const std::size_t vertex : left) {
        const bool own = vertex == ear[0] || vertex == ear[1] || vertex == ear[2];
        if (!own && covers(ear, vertex)) {
            return false;
        }
    }
    return true;
}

void add_triangle(const Polygon& polygon, const std::array<std::size_t, 3>& corners,
                  std::vector<Polygon>& triangles) {
    Polygon triangle;
    for (const std::size_t k : corners) {
        triangle.vertices.push_back(polygon.vertices[k]);
        if (!polygon.normals.empty()) {
            triangle.normals.push_back(polygon.normals[k]);
        }
    }
    if (planarity_of(triangle.vertices).has_area()) {
        triangles.push_back(std::move(triangle));
    }
}

}  // namespace

std::vector<Polygon> split_into_triangles(const Polygon& polygon) {
    const Point normal = planarity_of(polygon.vertices).normal;
    const Outline outline(polygon.vertices, normal);
    std::vector<std::size_t> left(polygon.vertices.size());
    std::iota(left.begin(), left.end(), std::size_t{0});
    std::vector<Polygon> triangles;
    std::size_t at = 1;  // a convex polygon is then fanned from its first vertex
    while (left.size() > 3) {
        std::size_t tried = 0;
        while (tried < left.size() && !outline.is_ear(left, at % left.size())) {
            ++at;
            ++tried;
        }
        // Without any ear, as where the outline crosses itself, one corner is as good as another.
        at %= left.size();
        add_triangle(polygon, corner(left, at), triangles);
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(at));
    }
    add_triangle(polygon, {left[0], left[1], left[2]}, triangles);
    return triangles;
}

}  // namespace raytree
