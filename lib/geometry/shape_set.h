#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/affine_map.h"
#include "geometry/box.h"
#include "geometry/cone.h"
#include "geometry/polygon.h"
#include "geometry/sphere.h"
#include "geometry/triangle.h"
#include "scene/scene.h"

namespace raytree {

enum class ShapeKind : std::uint8_t { sphere, polygon, triangle, cone };

/// One shape of a scene as rays meet it.
struct Primitive {
    ShapeKind kind = ShapeKind::sphere;
    std::uint32_t shape = 0;      ///< place among the shapes of its kind
    std::uint32_t object = 0;     ///< place in Scene::objects
    std::int32_t part = -1;       ///< number of a mesh's triangle, -1: the object is this one shape
    std::int32_t transform = -1;  ///< place among the transforms, -1: none
};

/// What is known of the start of a ray that leaves `leaving`, for the shape `id`.
inline Start start_on(PrimitiveId id, PrimitiveId leaving) {
    return leaving == no_primitive ? Start::anywhere
           : leaving == id         ? Start::on_this_shape
                                   : Start::on_another_shape;
}

/// What some shape of a set may have: where a fact is false, no shape is asked for it.
struct ShapeFacts {
    bool transforms = true;
    bool interpolated_normals = true;
};

/// All shapes of a scene, prepared for intersection in the arithmetic T. Meshes become triangles,
/// and so do polygons of three vertices. A PrimitiveId is a place in the order of the scene. The
/// vertices of meshes stay where they are: the scene given must outlive the set.
template <class T> class ShapeSet {
  public:
    explicit ShapeSet(const Scene& scene);

    std::size_t size() const { return object_of_.size(); }
    Primitive operator[](PrimitiveId id) const;

    /// The ray's intersections with one shape, t in the world. `leaving` is the shape that the ray
    /// starts on, or no_primitive for one that starts in free space.
    Roots<T> intersect(PrimitiveId id, const Ray<T>& ray, PrimitiveId leaving) const;

    /// The point that the ray meets at `t` on the shape, in the world.
    template <ShapeFacts facts = ShapeFacts{}>
    SurfacePoint<T> surface_at(PrimitiveId id, const Ray<T>& ray, T t) const;

    /// A box around the shape, wide enough for every hit that `intersect` reports: 64 u times its
    /// largest coordinate on every side.
    Box bounds(PrimitiveId id) const;

    /// The shape itself, of a primitive of that kind.
    const SphereShape<T>& sphere(const Primitive& p) const { return spheres_[p.shape]; }
    const ConeShape<T>& cone(const Primitive& p) const { return cones_[p.shape]; }
    TriangleShape<T> triangle(const Primitive& p) const;

    /// What the shapes take, the scene's own vertices left out.
    std::size_t bytes() const;

  private:
    /// What all primitives of an object have in common.
    struct Part {
        ShapeKind kind = ShapeKind::sphere;
        std::int32_t transform = -1;
        PrimitiveId first = 0;       ///< of its primitives
        std::uint32_t shape = 0;     ///< place of the first among the shapes of its kind
        const Mesh* mesh = nullptr;  ///< whose triangles they are, if so
    };

    void add(const Object& object, std::uint32_t place);
    void add_polygon(const Polygon& polygon, const std::string& name, Part& part);
    void add_mesh(const Mesh& mesh, Part& part);
    TriangleShape<T> mesh_triangle(const Mesh& mesh, std::uint32_t place) const;
    /// Whether there are any; then they are in `normals`.
    bool normals_of(const Primitive& triangle, VertexNormals<T>& normals) const;

    std::vector<Part> parts_;               ///< by object
    std::vector<std::uint32_t> object_of_;  ///< by primitive
    std::vector<SphereShape<T>> spheres_;
    std::vector<PolygonShape<T>> polygons_;
    std::vector<TriangleShape<T>> triangles_;                      ///< that are not of a mesh
    std::vector<std::optional<VertexNormals<T>>> vertex_normals_;  ///< of these
    std::vector<ConeShape<T>> cones_;
    std::vector<AffineMap<T>> transforms_;
    std::vector<Box> polygon_boxes_;
};

/// The name that a primitive is reported by: its object's, and "name#k" for a mesh's triangle k.
std::string primitive_name(const Scene& scene, const Primitive& primitive);

// Inline, though instantiated in one place: so the kernels have them in their instruction set.

template <class T> inline Primitive ShapeSet<T>::operator[](PrimitiveId id) const {
    const std::uint32_t object = object_of_[id];
    const Part& part = parts_[object];
    const std::uint32_t number = id - part.first;
    return {part.kind, part.shape + number, object,
            part.mesh ? static_cast<std::int32_t>(number) : -1, part.transform};
}

template <class T>
inline TriangleShape<T> ShapeSet<T>::mesh_triangle(const Mesh& mesh, std::uint32_t place) const {
    const Mesh::Triangle& corners = mesh.triangles[place];
    const auto vertex = [&](std::size_t k) {
        return vector_cast<T>(mesh.vertices[static_cast<std::size_t>(corners[k].vertex)]);
    };
    return {{vertex(0), vertex(1), vertex(2)}};
}

template <class T> inline TriangleShape<T> ShapeSet<T>::triangle(const Primitive& p) const {
    const Mesh* const mesh = parts_[p.object].mesh;
    return mesh ? mesh_triangle(*mesh, static_cast<std::uint32_t>(p.part)) : triangles_[p.shape];
}

template <class T> inline Roots<T> ShapeSet<T>::intersect(PrimitiveId id, const Ray<T>& ray,
                                                          PrimitiveId leaving) const {
    const Primitive primitive = (*this)[id];
    const Start start = start_on(id, leaving);
    const auto meet_shape = [&](const Ray<T>& r) {
        switch (primitive.kind) {
            case ShapeKind::sphere:
                return raytree::intersect(spheres_[primitive.shape], r, start);
            case ShapeKind::polygon:
                return raytree::intersect(polygons_[primitive.shape], r, start);
            case ShapeKind::triangle:
                return raytree::intersect(triangle(primitive), r, start);
            default:
                return raytree::intersect(cones_[primitive.shape], r, start);
        }
    };
    if (primitive.transform < 0) {
        return meet_shape(ray);
    }
    return meet_shape(
        transforms_[static_cast<std::size_t>(primitive.transform)].ray_to_own_space(ray));
}

template <class T> template <ShapeFacts facts>
SurfacePoint<T> ShapeSet<T>::surface_at(PrimitiveId id, const Ray<T>& ray, T t) const {
    const Primitive primitive = (*this)[id];
    const auto at = [&](const Ray<T>& r) {
        switch (primitive.kind) {
            case ShapeKind::sphere:
                return raytree::surface_at(spheres_[primitive.shape], r, t);
            case ShapeKind::polygon:
                return raytree::surface_at(polygons_[primitive.shape], r, t);
            case ShapeKind::triangle: {
                VertexNormals<T> normals;
                const bool smooth = facts.interpolated_normals && normals_of(primitive, normals);
                return raytree::surface_at(triangle(primitive), smooth ? &normals : nullptr, r, t);
            }
            default:
                return raytree::surface_at(cones_[primitive.shape], r, t);
        }
    };
    if (!facts.transforms || primitive.transform < 0) {
        return at(ray);
    }
    const AffineMap<T>& map = transforms_[static_cast<std::size_t>(primitive.transform)];
    const SurfacePoint<T> own = at(map.ray_to_own_space(ray));
    return {map.point_to_world(own.point), map.normal_to_world(own.geometric_normal),
            map.normal_to_world(own.shading_normal)};
}

extern template class ShapeSet<float>;
extern template class ShapeSet<double>;
extern template class ShapeSet<Quad>;

}  // namespace raytree
