#include "drawing/mesh.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace raytree::inspector {
namespace {

void put(std::vector<float>& list, const Point3& p) {
    list.insert(list.end(),
                {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
}

void put(std::vector<std::uint8_t>& list, const Paint& paint) {
    list.insert(list.end(), {paint.ink.r, paint.ink.g, paint.ink.b, paint.alpha});
}

/// The k-th of `sides` unit vectors around an axis.
Point3 spoke(const Across& axes, int k, int sides) {
    const double angle = 2 * std::numbers::pi * k / sides;
    return std::cos(angle) * axes.u + std::sin(angle) * axes.v;
}

}  // namespace

std::int32_t Mesh::add_point(const Point3& p, const Point3& normal, const Paint& paint) {
    put(points, p);
    put(normals, normal);
    put(colours, paint);
    return static_cast<std::int32_t>(points.size() / 3) - 1;
}

std::int32_t Lines::add_point(const Point3& p, const Paint& paint) {
    put(points, p);
    put(colours, paint);
    return static_cast<std::int32_t>(points.size() / 3) - 1;
}

void Lines::add(const Point3& a, const Paint& paint_a, const Point3& b, const Paint& paint_b) {
    const std::int32_t first = add_point(a, paint_a);
    segments.insert(segments.end(), {first, add_point(b, paint_b)});
}

Across across(const Point3& unit) {
    const Point3 other = std::abs(unit.x) < 0.7 ? Point3(1, 0, 0) : Point3(0, 1, 0);
    const Point3 u = glm::normalize(glm::cross(unit, other));
    return {u, glm::cross(unit, u)};
}

void add_tube(Mesh& mesh, const TubeEnd& from, const TubeEnd& to, int sides) {
    const double length = glm::length(to.at - from.at);
    if (!(length > 0)) {
        return;
    }
    const Across axes = across((to.at - from.at) / length);
    const auto start = static_cast<std::int32_t>(mesh.points.size() / 3);
    for (int k = 0; k < sides; ++k) {
        const Point3 out = spoke(axes, k, sides);
        mesh.add_point(from.at + from.radius * out, out, from.paint);
        mesh.add_point(to.at + to.radius * out, out, to.paint);
    }
    for (int k = 0; k < sides; ++k) {
        const std::int32_t a = start + 2 * k, b = start + 2 * ((k + 1) % sides);
        mesh.add_triangle(a, b, b + 1);
        mesh.add_triangle(a, b + 1, a + 1);
    }
}

void add_cone(Mesh& mesh, const Point3& base, const Point3& tip, double radius, const Paint& paint,
              int sides) {
    const Point3 axis = glm::normalize(tip - base);
    const Across axes = across(axis);
    const double slope = radius / glm::length(tip - base);
    const auto start = static_cast<std::int32_t>(mesh.points.size() / 3);
    for (int k = 0; k < sides; ++k) {
        const Point3 out = spoke(axes, k, sides);
        const Point3 normal = glm::normalize(out + slope * axis);
        mesh.add_point(base + radius * out, normal, paint);
        mesh.add_point(tip, normal, paint);
        mesh.add_point(base + radius * out, -axis, paint);
    }
    const std::int32_t middle = mesh.add_point(base, -axis, paint);
    for (int k = 0; k < sides; ++k) {
        const std::int32_t a = start + 3 * k, b = start + 3 * ((k + 1) % sides);
        mesh.add_triangle(a, b, a + 1);
        mesh.add_triangle(b + 2, a + 2, middle);
    }
}

void add_ball(Mesh& mesh, const Point3& centre, double radius, const Paint& paint, int slices) {
    const int stacks = slices / 2;
    const auto start = static_cast<std::int32_t>(mesh.points.size() / 3);
    for (int j = 0; j <= stacks; ++j) {
        const double polar = std::numbers::pi * j / stacks;
        for (int i = 0; i < slices; ++i) {
            const double around = 2 * std::numbers::pi * i / slices;
            const Point3 out(std::sin(polar) * std::cos(around), std::cos(polar),
                             std::sin(polar) * std::sin(around));
            mesh.add_point(centre + radius * out, out, paint);
        }
    }
    for (int j = 0; j < stacks; ++j) {
        for (int i = 0; i < slices; ++i) {
            const std::int32_t next = (i + 1) % slices;
            const std::int32_t a = start + j * slices + i, b = start + j * slices + next;
            if (j > 0) {
                mesh.add_triangle(a, b, b + slices);
            }
            if (j + 1 < stacks) {
                mesh.add_triangle(a, b + slices, a + slices);
            }
        }
    }
}

void add_ring(Mesh& mesh, const Point3& centre, const Point3& axis, double inner, double outer,
              const Paint& paint, int sides) {
    const Across axes = across(axis);
    const auto start = static_cast<std::int32_t>(mesh.points.size() / 3);
    for (int k = 0; k < sides; ++k) {
        const Point3 out = spoke(axes, k, sides);
        mesh.add_point(centre + inner * out, axis, paint);
        mesh.add_point(centre + outer * out, axis, paint);
    }
    for (int k = 0; k < sides; ++k) {
        const std::int32_t a = start + 2 * k, b = start + 2 * ((k + 1) % sides);
        mesh.add_triangle(a, a + 1, b + 1);
        mesh.add_triangle(a, b + 1, b);
    }
}

void add_quad(Mesh& mesh, const Point3& a, const Point3& b, const Point3& c, const Point3& d,
              const Paint& paint) {
    add_quad(mesh, a, b, c, d, paint, paint);
}

void add_quad(Mesh& mesh, const Point3& a, const Point3& b, const Point3& c, const Point3& d,
              const Paint& paint, const Paint& far_paint) {
    const Point3 normal = glm::normalize(glm::cross(c - a, d - b));
    const std::int32_t first = mesh.add_point(a, normal, paint);
    mesh.add_point(b, normal, paint);
    mesh.add_point(c, normal, far_paint);
    mesh.add_point(d, normal, far_paint);
    mesh.add_triangle(first, first + 1, first + 2);
    mesh.add_triangle(first, first + 2, first + 3);
}

}  // namespace raytree::inspector
