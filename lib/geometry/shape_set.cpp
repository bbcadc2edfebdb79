#include "geometry/shape_set.h"

#include <algorithm>
#include <cmath>

#include "scene/input_error.h"
#include "scene/progress.h"

namespace raytree {
namespace {

Vec3<double> to_double(const Vec3<float>& v) { return vector_cast<double>(v); }
Vec3<double> to_double(const Vec3<double>& v) { return v; }
Vec3<double> to_double(const Vec3<Quad>& v) { return vector_cast<double>(v); }

[[noreturn]] void refuse(const std::string& object, const std::string& why) {
    throw InputError("", "object '" + object + "'", why + " for this precision");
}

/// The scene's length in the arithmetic T, which may have too short a range for it.
template <class T> T narrow(double length, const std::string& object) {
    const T result = static_cast<T>(length);
    if (!(abs(result) <= Real<T>::largest_length)) {
        refuse(object, "a coordinate or a radius is too large");
    }
    return result;
}

template <class T> Vec3<T> narrow(const Vec3<double>& v, const std::string& object) {
    return {narrow<T>(v.x, object), narrow<T>(v.y, object), narrow<T>(v.z, object)};
}

/// Refuses a shape of which nothing is left but 0 once lengths are multiplied with each other.
template <class T> void expect_size(T size, const std::string& object) {
    if (!(size * Real<T>::largest_length >= 1)) {
        refuse(object, "it is too small");
    }
}

template <class T> T extent_of(const std::vector<Vec3<T>>& vertices) {
    T extent = 0;
    for (const Vec3<T>& vertex : vertices) {
        extent = max_of(extent, largest_component<T>(vertex - vertices[0]));
    }
    return extent;
}

/// Powers of a cone's slope meet squares of its lengths in the discriminant.
template <class T> void expect_in_range(const ConeShape<T>& cone, const std::string& object) {
    expect_size(cone.height, object);
    const T steep = 1 + cone.slope * cone.slope;
    const T extent = largest_component(cone.base) + cone.height + cone.base_radius;
    if (!isfinite(steep * steep * extent * extent)) {
        refuse(object, "its sides are too flat or its lengths too large");
    }
}

template <class T>
std::vector<Vec3<T>> narrow_all(const std::vector<Point>& points, const std::string& object) {
    std::vector<Vec3<T>> result;
    result.reserve(points.size());
    for (const Point& p : points) {
        result.push_back(narrow<T>(p, object));
    }
    return result;
}

/// A vector of which only the direction counts, with lengths near 1, so that any arithmetic has the
/// range for it.
template <class T> Vec3<T> near_one(const Point& v) {
    const double largest = largest_component(v);
    const int exponent = largest > 0 ? std::ilogb(largest) : 0;
    return vector_cast<T>(
        Point(std::ldexp(v.x, -exponent), std::ldexp(v.y, -exponent), std::ldexp(v.z, -exponent)));
}

template <class T> std::vector<Vec3<T>> narrow_directions(const std::vector<Point>& directions) {
    std::vector<Vec3<T>> result;
    result.reserve(directions.size());
    for (const Point& v : directions) {
        result.push_back(near_one<T>(v));
    }
    return result;
}

Box around_sphere(const Point& center, double radius) {
    Box box;
    box.include(center);
    box.pad(radius);
    return box;
}

/// The box of a circle about `center` in the plane across the unit vector `axis`.
void include_disc(Box& box, const Point& center, const Point& axis, double radius) {
    Point reach;
    for (int k = 0; k < 3; ++k) {
        reach[k] = radius * std::sqrt(std::max(0.0, 1 - axis[k] * axis[k]));
    }
    box.include(center - reach);
    box.include(center + reach);
}

/// The box of the eight corners of `own`, taken to the world.
template <class T> Box transformed(const Box& own, const AffineMap<T>& map) {
    Box box;
    for (int corner = 0; corner < 8; ++corner) {
        Vec3<T> p;
        for (int k = 0; k < 3; ++k) {
            p[k] = static_cast<T>((corner >> k & 1) != 0 ? own.max[k] : own.min[k]);
        }
        box.include(to_double(map.point_to_world(p)));
    }
    return box;
}

/// What a hit may lie outside the ideal shape by rounding, and a polygon's vertices off its plane.
template <class T> double margin(const Box& box) {
    const double reach = std::max(largest_component(box.min), largest_component(box.max));
    return 64 * static_cast<double>(max_of(static_cast<double>(Real<T>::unit_roundoff), 0x1p-53)) *
           reach;
}

}  // namespace

std::string primitive_name(const Scene& scene, const Primitive& primitive) {
    const std::string& name = scene.objects[primitive.object].name;
    return primitive.part < 0 ? name : name + '#' + std::to_string(primitive.part);
}

template <class T> ShapeSet<T>::ShapeSet(const Scene& scene) {
    ProgressCounter progress("preparing");
    for (std::size_t k = 0; k < scene.objects.size(); ++k) {
        progress.at(k, scene.objects.size());
        const std::size_t first = size();
        add(scene.objects[k], static_cast<std::uint32_t>(k));
        for (std::size_t id = first; scene.objects[k].transform && id < size(); ++id) {
            const Box box = bounds(static_cast<PrimitiveId>(id));
            if (!(max_of(largest_component(box.min), largest_component(box.max)) <=
                  static_cast<double>(Real<T>::largest_length))) {
                refuse(scene.objects[k].name, "its transform takes it too far away");
            }
        }
    }
}

template <class T> void ShapeSet<T>::add(const Object& object, std::uint32_t place) {
    Part part;
    part.first = static_cast<PrimitiveId>(size());
    if (object.transform) {
        part.transform = static_cast<std::int32_t>(transforms_.size());
        transforms_.emplace_back(*object.transform);
        if (!transforms_.back().in_range()) {
            refuse(object.name, "its transform has factors too large or too small");
        }
    }
    std::size_t count = 1;
    if (const auto* sphere = std::get_if<Sphere>(&object.shape)) {
        part.kind = ShapeKind::sphere;
        part.shape = static_cast<std::uint32_t>(spheres_.size());
        spheres_.push_back(
            {narrow<T>(sphere->center, object.name), narrow<T>(sphere->radius, object.name)});
        expect_size(spheres_.back().radius, object.name);
    } else if (const auto* cone = std::get_if<Cone>(&object.shape)) {
        part.kind = ShapeKind::cone;
        part.shape = static_cast<std::uint32_t>(cones_.size());
        cones_.push_back(make_cone<T>(
            narrow<T>(cone->base, object.name), narrow<T>(cone->base_radius, object.name),
            narrow<T>(cone->apex, object.name), narrow<T>(cone->apex_radius, object.name)));
        expect_size(max_of(static_cast<T>(cone->base_radius), static_cast<T>(cone->apex_radius)),
                    object.name);
        expect_in_range(cones_.back(), object.name);
    } else if (const auto* polygon = std::get_if<Polygon>(&object.shape)) {
        add_polygon(*polygon, object.name, part);
    } else {
        const Mesh& mesh = std::get<Mesh>(object.shape);
        add_mesh(mesh, part);
        count = mesh.triangles.size();
    }
    parts_.push_back(part);
    object_of_.resize(size() + count, place);
}

template <class T>
void ShapeSet<T>::add_polygon(const Polygon& polygon, const std::string& name, Part& part) {
    const auto vertices = narrow_all<T>(polygon.vertices, name);
    const auto normals = narrow_directions<T>(polygon.normals);
    expect_size(extent_of(vertices), name);
    if (!isfinite(
            largest_component(supporting_plane(std::span<const Vec3<T>>(vertices)).normal.vec()))) {
        refuse(name, "it is too narrow");
    }
    if (vertices.size() == 3) {
        part.kind = ShapeKind::triangle;
        part.shape = static_cast<std::uint32_t>(triangles_.size());
        triangles_.push_back({{vertices[0], vertices[1], vertices[2]}});
        auto& of_vertices = vertex_normals_.emplace_back();
        if (!normals.empty()) {
            of_vertices = {UnitVec3<T>::of(normals[0]), UnitVec3<T>::of(normals[1]),
                           UnitVec3<T>::of(normals[2])};
        }
        return;
    }
    part.kind = ShapeKind::polygon;
    part.shape = static_cast<std::uint32_t>(polygons_.size());
    polygons_.push_back(make_polygon<T>(vertices, normals));

    // The plane goes through the mean of the vertices: a hit may be as far off their box as the
    // farthest vertex is off the plane, times at most sqrt(3) along the dropped axis.
    const Plane<T>& plane = polygons_.back().plane;
    Box box;
    double off_plane = 0;
    for (const Vec3<T>& vertex : vertices) {
        box.include(to_double(vertex));
        off_plane = std::max(off_plane,
                             static_cast<double>(abs(inner(plane.normal, vertex - plane.point))));
    }
    box.pad(2 * off_plane);
    polygon_boxes_.push_back(box);
}

template <class T> void ShapeSet<T>::add_mesh(const Mesh& mesh, Part& part) {
    for (const Point& vertex : mesh.vertices) {
        narrow<T>(vertex, mesh.file);
    }
    part.kind = ShapeKind::triangle;
    part.shape = 0;
    part.mesh = &mesh;
}

template <class T>
bool ShapeSet<T>::normals_of(const Primitive& triangle, VertexNormals<T>& normals) const {
    const Mesh* const mesh = parts_[triangle.object].mesh;
    if (!mesh) {
        const auto& given = vertex_normals_[triangle.shape];
        normals = given.value_or(normals);
        return given.has_value();
    }
    if (!mesh->smooth) {
        return false;
    }
    const Mesh::Triangle& corners = mesh->triangles[static_cast<std::size_t>(triangle.part)];
    for (std::size_t k = 0; k < 3; ++k) {
        if (corners[k].normal < 0) {
            return false;
        }
        normals[k] = UnitVec3<T>::of(
            near_one<T>(mesh->normals[static_cast<std::size_t>(corners[k].normal)]));
    }
    return true;
}

template <class T> std::size_t ShapeSet<T>::bytes() const {
    const auto held = [](const auto& list) {
        return list.capacity() * sizeof(typename std::decay_t<decltype(list)>::value_type);
    };
    return held(parts_) + held(object_of_) + held(spheres_) + held(polygons_) + held(triangles_) +
           held(vertex_normals_) + held(cones_) + held(transforms_) + held(polygon_boxes_);
}

template <class T> Box ShapeSet<T>::bounds(PrimitiveId id) const {
    const Primitive primitive = (*this)[id];
    Box box;
    switch (primitive.kind) {
        case ShapeKind::sphere: {
            const SphereShape<T>& sphere = spheres_[primitive.shape];
            box = around_sphere(to_double(sphere.center), static_cast<double>(sphere.radius));
            break;
        }
        case ShapeKind::polygon:
            box = polygon_boxes_[primitive.shape];
            break;
        case ShapeKind::triangle:
            for (const Vec3<T>& vertex : triangle(primitive).vertices) {
                box.include(to_double(vertex));
            }
            break;
        case ShapeKind::cone: {
            const ConeShape<T>& cone = cones_[primitive.shape];
            const Point base = to_double(cone.base);
            const Point axis = to_double(cone.axis.vec());
            const auto height = static_cast<double>(cone.height);
            const auto radius = static_cast<double>(cone.base_radius);
            include_disc(box, base, axis, radius);
            include_disc(box, base + height * axis, axis,
                         radius + static_cast<double>(cone.slope) * height);
            break;
        }
    }
    box.pad(margin<T>(box));
    if (primitive.transform >= 0) {
        box = transformed(box, transforms_[static_cast<std::size_t>(primitive.transform)]);
        box.pad(margin<T>(box));
    }
    return box;
}

template class ShapeSet<float>;
template class ShapeSet<double>;
template class ShapeSet<Quad>;

}  // namespace raytree
