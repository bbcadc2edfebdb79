#include "geometry/polygon.h"

#include <optional>

namespace raytree {
namespace {

/// Where the line of constant v meets an edge, and the normal there.
template <class T> struct Crossing {
    T u;
    Vec3<T> normal;
};

template <class T>
Crossing<T> crossing_of(const PolygonShape<T>& polygon, std::size_t from, std::size_t to, T v) {
    const auto& a = polygon.outline[from];
    const auto& b = polygon.outline[to];
    const T share = (v - a.v) / (b.v - a.v);
    return {
        fma(share, b.u - a.u, a.u),
        along(polygon.normals[from], share, Vec3<T>(polygon.normals[to] - polygon.normals[from]))};
}

}  // namespace

template <class T>
PolygonShape<T> make_polygon(std::span<const Vec3<T>> vertices, std::span<const Vec3<T>> normals) {
    PolygonShape<T> polygon;
    polygon.plane = supporting_plane(vertices);
    polygon.axes = kept_axes(polygon.plane.normal.vec());
    for (const Vec3<T>& vertex : vertices) {
        polygon.vertices.push_back(vertex);
        polygon.outline.push_back({vertex[polygon.axes.u], vertex[polygon.axes.v]});
    }
    for (const Vec3<T>& normal : normals) {
        polygon.normals.push_back(UnitVec3<T>::of(normal));
    }
    return polygon;
}

template <class T>
UnitVec3<T> interpolated_normal(const PolygonShape<T>& polygon, const Vec3<T>& point) {
    const T u = point[polygon.axes.u];
    const T v = point[polygon.axes.v];
    std::optional<Crossing<T>> left, right;
    const auto& outline = polygon.outline;
    for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
        if ((outline[i].v > v) == (outline[j].v > v)) {
            continue;
        }
        const Crossing<T> crossing = crossing_of(polygon, j, i, v);
        if (crossing.u <= u && (!left || crossing.u > left->u)) {
            left = crossing;
        }
        if (crossing.u >= u && (!right || crossing.u < right->u)) {
            right = crossing;
        }
    }
    if (!left && !right) {  // rounding has moved a hit on the rim just off the outline
        return polygon.plane.normal;
    }
    if (!left || !right) {
        return UnitVec3<T>::of(left ? left->normal : right->normal);
    }
    const T width = right->u - left->u;
    const T share = width > 0 ? (u - left->u) / width : T(0);
    return UnitVec3<T>::of(along(left->normal, share, Vec3<T>(right->normal - left->normal)));
}

#define RAYTREE_INSTANTIATE(T)                                                                    \
    template PolygonShape<T> make_polygon<T>(std::span<const Vec3<T>>, std::span<const Vec3<T>>); \
    template UnitVec3<T> interpolated_normal<T>(const PolygonShape<T>&, const Vec3<T>&);
RAYTREE_INSTANTIATE(float)
RAYTREE_INSTANTIATE(double)
RAYTREE_INSTANTIATE(Quad)
#undef RAYTREE_INSTANTIATE

}  // namespace raytree
