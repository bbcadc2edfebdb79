#pragma once

#include <array>
#include <optional>

#include "geometry/plane.h"
#include "geometry/ray_frame.h"

namespace raytree {

/// A triangle, of a mesh or a polygon of three vertices.
template <class T> struct TriangleShape {
    std::array<Vec3<T>, 3> vertices{};
    Plane<T> plane;
    std::int32_t normals = -1;  ///< place of its vertex normals, -1: none
};

template <class T> using VertexNormals = std::array<Vec3<T>, 3>;

template <class T> TriangleShape<T> make_triangle(const std::array<Vec3<T>, 3>& vertices) {
    return {vertices, supporting_plane(std::span<const Vec3<T>>(vertices)), -1};
}

/// Whether the ray's line passes through the triangle, edges and vertices included. Watertight:
/// both triangles on an edge compute the same edge function up to its sign, so that no ray passes
/// between them (Woop, Benthin & Wald, "Watertight ray/triangle intersection", JCGT 2(1), 2013).
template <class T>
bool passes_through(const TriangleShape<T>& triangle, const Ray<T>& ray, const RayFrame<T>& frame) {
    std::array<T, 3> px, py;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3<T> v = triangle.vertices[i] - ray.origin;
        px[i] = frame.x_of(v);
        py[i] = frame.y_of(v);
    }
    const T e0 = px[2] * py[1] - py[2] * px[1];
    const T e1 = px[0] * py[2] - py[0] * px[2];
    const T e2 = px[1] * py[0] - py[1] * px[0];
    const bool negative = e0 < 0 || e1 < 0 || e2 < 0;
    const bool positive = e0 > 0 || e1 > 0 || e2 > 0;
    return negative != positive;
}

template <class T>
Roots<T> intersect(const TriangleShape<T>& triangle, const Ray<T>& ray, Start start) {
    Roots<T> roots;
    if (start == Start::on_this_shape) {
        return roots;
    }
    const RayFrame<T> frame(ray.direction);
    if (passes_through(triangle, ray, frame)) {
        const auto [nearest, farthest] =
            passage(std::span<const Vec3<T>>(triangle.vertices), ray, frame);
        roots.add(meet(triangle.plane, ray, start, nearest, farthest));
    }
    return roots;
}

/// The normal interpolated at a point of the triangle by its barycentric coordinates, which on a
/// triangle is what bilinear interpolation gives.
template <class T> UnitVec3<T> interpolated_normal(const TriangleShape<T>& triangle,
                                                   const VertexNormals<T>& normals,
                                                   const Vec3<T>& point) {
    Vec3<T> sum(T(0));
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3<T> area = outer<T>(triangle.vertices[(i + 1) % 3] - point,
                                      triangle.vertices[(i + 2) % 3] - point);
        sum += inner(triangle.plane.normal, area) * normals[i];
    }
    return UnitVec3<T>::of(sum);
}

/// `normals`: those of the triangle's vertices, unit; null where there are none.
template <class T> SurfacePoint<T> surface_at(const TriangleShape<T>& triangle,
                                              const VertexNormals<T>* normals, const Ray<T>& ray,
                                              T t) {
    const Vec3<T> point = point_on(triangle.plane, ray, t);
    return {point, triangle.plane.normal,
            normals ? interpolated_normal(triangle, *normals, point) : triangle.plane.normal};
}

}  // namespace raytree
