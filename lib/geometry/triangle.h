#pragma once

#include <array>
#include <optional>

#include "geometry/plane.h"
#include "geometry/ray_frame.h"

namespace raytree {

/// A triangle, of a mesh or a polygon of three vertices.
template <class T> struct TriangleShape { std::array<Vec3<T>, 3> vertices{}; };

/// The unit normals of a triangle's vertices.
template <class T> using VertexNormals = std::array<Vec3<T>, 3>;

template <class T> Plane<T> supporting_plane(const TriangleShape<T>& triangle) {
    return supporting_plane(std::span<const Vec3<T>>(triangle.vertices));
}

/// Where the ray meets the triangle's plane, as `meet` of a plane says, without what would only be
/// a detour to one number: the normal is left as long as it is, and the point is a vertex. The
/// bound is the same.
template <class T> T meet_plane(const TriangleShape<T>& triangle, const Ray<T>& ray, Start start,
                                T nearest, T farthest) {
    const auto& [a, b, c] = triangle.vertices;
    const Vec3<T> normal = outer<T>(b - a, c - a);
    const T distance = inner<T>(normal, a - ray.origin);
    if (start != Start::anywhere) {
        const T extent =
            max_of(largest_component(a), max_of(largest_component(b), largest_component(c)));
        const T error = 16 * Real<T>::unit_roundoff * extent + 4 * ray.origin_error;
        if (abs(distance) <= error * length(normal)) {
            return 0;
        }
    }
    const T speed = inner(normal, ray.direction);
    return speed == 0 ? T(0) : min_of(max_of(distance / speed, nearest), farthest);
}

/// Whether points are on both sides of 0, up to the rounding of their places.
template <class T> bool reach_across_zero(const std::array<T, 3>& p) {
    const T low = min_of(p[0], min_of(p[1], p[2]));
    const T high = max_of(p[0], max_of(p[1], p[2]));
    const T error = 4 * Real<T>::unit_roundoff * max_of(abs(low), abs(high));
    return (low <= error) & (high >= -error);
}

/// Whether the origin of a plane is in the triangle of the points (px, py), edges and vertices
/// included. Of points that are all but one, seen from so far away, the edge functions' signs are
/// noise, and only their places tell that they are elsewhere.
template <class T> bool encloses_origin(const std::array<T, 3>& px, const std::array<T, 3>& py) {
    const T e0 = px[2] * py[1] - py[2] * px[1];
    const T e1 = px[0] * py[2] - py[0] * px[2];
    const T e2 = px[1] * py[0] - py[1] * px[0];
    // Asked for all at once: no processor could guess the answer to one of them.
    const bool negative = (e0 < 0) | (e1 < 0) | (e2 < 0);
    const bool positive = (e0 > 0) | (e1 > 0) | (e2 > 0);
    return (negative != positive) & reach_across_zero(px) & reach_across_zero(py);
}

/// Whether the ray's line passes through the triangle, edges and vertices included. Watertight:
/// both triangles on an edge compute the same edge function up to its sign, so that no ray passes
/// between them (Woop, Benthin & Wald, "Watertight ray/triangle intersection", JCGT 2(1), 2013).
/// Decided as exactly where the line passes every edge by more than 16 u times the way from the
/// origin to the triangle's far side.
template <class T>
bool passes_through(const TriangleShape<T>& triangle, const Ray<T>& ray, const RayFrame<T>& frame) {
    std::array<T, 3> px, py;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3<T> v = triangle.vertices[i] - ray.origin;
        px[i] = frame.x_of(v);
        py[i] = frame.y_of(v);
    }
    return encloses_origin(px, py);
}

/// The intersection of a ray whose line passes through the triangle.
template <class T> Roots<T> intersect_inside(const TriangleShape<T>& triangle, const Ray<T>& ray,
                                             const Passage<T>& passage, Start start) {
    Roots<T> roots;
    roots.add(meet_plane(triangle, ray, start, passage.nearest, passage.farthest));
    return roots;
}

template <class T>
Roots<T> intersect(const TriangleShape<T>& triangle, const Ray<T>& ray, Start start) {
    if (start == Start::on_this_shape) {
        return {};
    }
    const RayFrame<T> frame(ray.direction);
    if (!passes_through(triangle, ray, frame)) {
        return {};
    }
    const std::span<const Vec3<T>> vertices(triangle.vertices);
    return intersect_inside(triangle, ray, passage(vertices, ray, frame), start);
}

/// The normal interpolated at a point of the triangle by its barycentric coordinates, which on a
/// triangle is what bilinear interpolation gives.
template <class T>
UnitVec3<T> interpolated_normal(const TriangleShape<T>& triangle, const UnitVec3<T>& normal,
                                const VertexNormals<T>& normals, const Vec3<T>& point) {
    Vec3<T> sum(T(0));
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3<T> area = outer<T>(triangle.vertices[(i + 1) % 3] - point,
                                      triangle.vertices[(i + 2) % 3] - point);
        sum += inner(normal, area) * normals[i];
    }
    return UnitVec3<T>::of(sum);
}

/// `normals`: those of the triangle's vertices, unit; null where there are none.
template <class T> SurfacePoint<T> surface_at(const TriangleShape<T>& triangle,
                                              const VertexNormals<T>* normals, const Ray<T>& ray,
                                              T t) {
    const Plane<T> plane = supporting_plane(triangle);
    const Vec3<T> point = point_on(plane, ray, t);
    return {point, plane.normal,
            normals ? interpolated_normal(triangle, plane.normal, *normals, point) : plane.normal};
}

}  // namespace raytree
