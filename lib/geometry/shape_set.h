#pragma once

#include <cstdint>
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

/// All shapes of a scene, prepared for intersection in the arithmetic T. Meshes become triangles,
/// and so do polygons of three vertices. A PrimitiveId is a place in the order of the scene.
template <class T> class ShapeSet {
  public:
    explicit ShapeSet(const Scene& scene);

    std::size_t size() const { return primitives_.size(); }
    const Primitive& operator[](PrimitiveId id) const { return primitives_[id]; }

    /// The ray's intersections with one shape, t in the world. `leaving` is the shape that the ray
    /// starts on, or no_primitive for one that starts in free space.
    Roots<T> intersect(PrimitiveId id, const Ray<T>& ray, PrimitiveId leaving) const;

    /// The point that the ray meets at `t` on the shape, in the world.
    SurfacePoint<T> surface_at(PrimitiveId id, const Ray<T>& ray, T t) const;

    /// A box around the shape, wide enough for every hit that `intersect` reports.
    Box bounds(PrimitiveId id) const;

  private:
    void add(const Object& object, std::uint32_t place);
    void add_polygon(const Polygon& polygon, Primitive primitive, const std::string& name);
    void add_mesh(const Mesh& mesh, Primitive primitive);
    void add_triangle(const std::array<Vec3<T>, 3>& vertices, const Vec3<T>* normals,
                      const Primitive& primitive);

    std::vector<Primitive> primitives_;
    std::vector<SphereShape<T>> spheres_;
    std::vector<PolygonShape<T>> polygons_;
    std::vector<TriangleShape<T>> triangles_;
    std::vector<VertexNormals<T>> vertex_normals_;
    std::vector<ConeShape<T>> cones_;
    std::vector<AffineMap<T>> transforms_;
    std::vector<Box> polygon_boxes_;
};

/// The name that a primitive is reported by: its object's, and "name#k" for a mesh's triangle k.
std::string primitive_name(const Scene& scene, const Primitive& primitive);

template <class T>
Roots<T> ShapeSet<T>::intersect(PrimitiveId id, const Ray<T>& ray, PrimitiveId leaving) const {
    const Primitive& primitive = primitives_[id];
    const Start start = leaving == no_primitive ? Start::anywhere
                        : leaving == id         ? Start::on_this_shape
                                                : Start::on_another_shape;
    const auto meet_shape = [&](const Ray<T>& r) {
        switch (primitive.kind) {
            case ShapeKind::sphere:
                return raytree::intersect(spheres_[primitive.shape], r, start);
            case ShapeKind::polygon:
                return raytree::intersect(polygons_[primitive.shape], r, start);
            case ShapeKind::triangle:
                return raytree::intersect(triangles_[primitive.shape], r, start);
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

}  // namespace raytree
