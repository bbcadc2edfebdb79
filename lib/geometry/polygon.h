#pragma once

#include <vector>

#include "geometry/plane.h"
#include "geometry/ray_frame.h"

namespace raytree {

/// A planar polygon, convex or concave, prepared for intersection.
template <class T> struct PolygonShape {
    /// A vertex in the two axes kept.
    struct Flat {
        T u, v;
    };

    Plane<T> plane;
    KeptAxes axes;
    std::vector<Vec3<T>> vertices;
    std::vector<Flat> outline;     ///< the vertices in the axes kept
    std::vector<Vec3<T>> normals;  ///< unit, one for each vertex, or none
};

/// `vertices`: three or more; `normals`: none or as many, of any length but 0.
template <class T>
PolygonShape<T> make_polygon(std::span<const Vec3<T>> vertices, std::span<const Vec3<T>> normals);

/// The axes of the ray's frame in the order in which a polygon is scanned: ties, rays through an
/// edge or a vertex, then fall as the model's rule has them on the axes kept wherever the frame has
/// these.
template <class T> struct ScanAxes {
    bool along_y;   ///< scan lines are those of constant y in the frame, else of constant x
    bool mirrored;  ///< whether the other axis is taken the other way round

    ScanAxes(const RayFrame<T>& frame, const KeptAxes& kept) {
        const int scanned = kept.v != frame.z ? kept.v : kept.u;
        along_y = scanned == frame.y;
        mirrored = kept.u == frame.z && (along_y ? frame.shear_x : frame.shear_y) > 0;
    }
};

/// Whether the ray's line passes through the polygon by the crossing (even-odd) rule, in the frame
/// of the ray. Watertight: the vertices have their places there whatever polygon they belong to, an
/// edge is always evaluated from its lower end to its upper, and the sign of its function is exact
/// (difference_of_products), so that of two polygons which share an edge exactly one is met. What
/// is uncertain are the places in the frame, as ray_frame.h says. Where the plane is met, plane.h
/// says.
template <class T>
bool passes_through(const PolygonShape<T>& polygon, const Ray<T>& ray, const RayFrame<T>& frame) {
    const ScanAxes<T> axes(frame, polygon.axes);
    const auto place = [&](const Vec3<T>& vertex) -> typename PolygonShape<T>::Flat {
        const Vec3<T> v = vertex - ray.origin;
        const T x = frame.x_of(v);
        const T y = frame.y_of(v);
        const T u = axes.along_y ? x : y;
        return {axes.mirrored ? -u : u, axes.along_y ? y : x};
    };
    bool odd = false;
    auto last = place(polygon.vertices.back());
    for (const Vec3<T>& vertex : polygon.vertices) {
        const auto next = place(vertex);
        if ((next.v > 0) != (last.v > 0)) {
            const auto& low = next.v > 0 ? last : next;
            const auto& high = next.v > 0 ? next : last;
            odd = odd != (difference_of_products(low.u, high.v, high.u, low.v) > 0);
        }
        last = next;
    }
    return odd;
}

template <class T>
Roots<T> intersect(const PolygonShape<T>& polygon, const Ray<T>& ray, Start start) {
    Roots<T> roots;
    if (start == Start::on_this_shape) {
        return roots;
    }
    const RayFrame<T> frame(ray.direction);
    if (passes_through(polygon, ray, frame)) {
        const auto [nearest, farthest] =
            passage(std::span<const Vec3<T>>(polygon.vertices), ray, frame);
        roots.add(meet(polygon.plane, ray, start, nearest, farthest));
    }
    return roots;
}

/// The normal interpolated bilinearly at a point inside: along the two edges that the line of
/// constant second coordinate meets next on either side, then between these two crossings
/// (Phong, "Illumination for computer generated pictures", 1975, for polygons). Unit.
template <class T>
UnitVec3<T> interpolated_normal(const PolygonShape<T>& polygon, const Vec3<T>& point);

template <class T>
SurfacePoint<T> surface_at(const PolygonShape<T>& polygon, const Ray<T>& ray, T t) {
    const Vec3<T> point = point_on(polygon.plane, ray, t);
    return {point, polygon.plane.normal,
            polygon.normals.empty() ? polygon.plane.normal : interpolated_normal(polygon, point)};
}

}  // namespace raytree
