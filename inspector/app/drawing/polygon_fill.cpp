#include "drawing/polygon_fill.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <span>

#include "geometry/plane.h"

namespace raytree::inspector {
namespace {

using Triangles = std::vector<std::array<Point3, 3>>;

struct Flat {
    double u, v;
};

/// An edge from its lower end to its upper.
struct Edge {
    Flat low, high;
    double u_at(double v) const {
        return low.u + (high.u - low.u) * ((v - low.v) / (high.v - low.v));
    }
};

bool is_convex(const std::vector<Point3>& vertices, const Point3& normal) {
    const std::size_t n = vertices.size();
    for (std::size_t k = 0; k < n; ++k) {
        const Point3 in = vertices[(k + 1) % n] - vertices[k];
        const Point3 out = vertices[(k + 2) % n] - vertices[(k + 1) % n];
        if (glm::dot(glm::cross(in, out), normal) < 0) {
            return false;
        }
    }
    // A star turns the same way everywhere but goes round more than once: the sum of its fan's
    // areas is more than its own.
    double fan = 0;
    for (std::size_t k = 1; k + 1 < n; ++k) {
        const Point3 area = glm::cross(vertices[k] - vertices[0], vertices[k + 1] - vertices[0]);
        if (glm::dot(area, normal) < 0) {
            return false;
        }
        fan += glm::length(area);
    }
    return fan <= glm::length(newell_normal<double>(vertices)) * (1 + 1e-9);
}

Triangles fan_of(const std::vector<Point3>& vertices) {
    Triangles triangles;
    for (std::size_t k = 1; k + 1 < vertices.size(); ++k) {
        triangles.push_back({vertices[0], vertices[k], vertices[k + 1]});
    }
    return triangles;
}

/// Cuts a polygon at the height of every vertex and of every crossing of two edges: between two
/// neighbouring heights it consists of trapezoids.
class Slicer {
  public:
    explicit Slicer(const std::vector<Point3>& vertices)
        : plane_(supporting_plane<double>(vertices)), axes_(kept_axes(plane_.normal.vec())) {
        for (std::size_t k = 0; k < vertices.size(); ++k) {
            add_edge(vertices[k], vertices[(k + 1) % vertices.size()]);
        }
        std::ranges::sort(heights_);
        heights_.erase(std::unique(heights_.begin(), heights_.end()), heights_.end());
    }

    Triangles slice() const {
        Triangles triangles;
        for (std::size_t k = 0; k + 1 < heights_.size(); ++k) {
            add_slice(heights_[k], heights_[k + 1], triangles);
        }
        return triangles;
    }

  private:
    void add_edge(const Point3& from, const Point3& to) {
        const Flat a{from[axes_.u], from[axes_.v]}, b{to[axes_.u], to[axes_.v]};
        heights_.push_back(a.v);
        if (a.v == b.v) {
            return;
        }
        const Edge edge = a.v < b.v ? Edge{a, b} : Edge{b, a};
        for (const Edge& other : edges_) {
            add_crossing(edge, other);
        }
        edges_.push_back(edge);
    }

    void add_crossing(const Edge& a, const Edge& b) {
        const double low = std::max(a.low.v, b.low.v), high = std::min(a.high.v, b.high.v);
        if (low < high) {
            const double below = a.u_at(low) - b.u_at(low), above = a.u_at(high) - b.u_at(high);
            if ((below < 0 && above > 0) || (below > 0 && above < 0)) {
                heights_.push_back(low + (high - low) * (below / (below - above)));
            }
        }
    }

    void add_slice(double low, double high, Triangles& triangles) const {
        const double middle = low + (high - low) / 2;
        std::vector<const Edge*> crossed;
        for (const Edge& edge : edges_) {
            if (edge.low.v < middle && edge.high.v > middle) {
                crossed.push_back(&edge);
            }
        }
        std::ranges::sort(crossed, {}, [&](const Edge* edge) { return edge->u_at(middle); });
        for (std::size_t k = 0; k + 1 < crossed.size(); k += 2) {
            const Point3 a = lifted(crossed[k]->u_at(low), low);
            const Point3 b = lifted(crossed[k + 1]->u_at(low), low);
            const Point3 c = lifted(crossed[k + 1]->u_at(high), high);
            const Point3 d = lifted(crossed[k]->u_at(high), high);
            triangles.push_back({a, b, c});
            triangles.push_back({a, c, d});
        }
    }

    /// The point of the plane above the two axes kept.
    Point3 lifted(double u, double v) const {
        const Point3& n = plane_.normal.vec();
        const int dropped = 3 - axes_.u - axes_.v;
        Point3 p(0.0);
        p[axes_.u] = u;
        p[axes_.v] = v;
        p[dropped] = plane_.point[dropped] - (n[axes_.u] * (u - plane_.point[axes_.u]) +
                                              n[axes_.v] * (v - plane_.point[axes_.v])) /
                                                 n[dropped];
        return p;
    }

    Plane<double> plane_;
    KeptAxes axes_;
    std::vector<Edge> edges_;
    std::vector<double> heights_;
};

}  // namespace

Triangles filled(const Polygon& polygon) {
    const std::vector<Point3>& vertices = polygon.vertices;
    if (vertices.size() == 3 || is_convex(vertices, newell_normal<double>(vertices))) {
        return fan_of(vertices);
    }
    return Slicer(vertices).slice();
}

std::vector<Point3> clipped(const std::vector<Point3>& outline, const Point3& n, double most) {
    std::vector<Point3> kept;
    for (std::size_t k = 0; k < outline.size(); ++k) {
        const Point3 &a = outline[k], &b = outline[(k + 1) % outline.size()];
        const double da = most - glm::dot(n, a), db = most - glm::dot(n, b);
        if (da >= 0) {
            kept.push_back(a);
        }
        if ((da < 0) != (db < 0)) {
            kept.push_back(a + (b - a) * (da / (da - db)));
        }
    }
    return kept;
}

}  // namespace raytree::inspector
