#include "tree/shape_rounding.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace raytree {
namespace {

using Vec = Vec3<double>;

/// The vertices of a planar primitive, in its own space.
std::vector<Vec> vertices_of(const Object& object, const Primitive& primitive) {
    if (const auto* polygon = std::get_if<Polygon>(&object.shape)) {
        return polygon->vertices;
    }
    const auto& mesh = std::get<Mesh>(object.shape);
    std::vector<Vec> result;
    for (const Mesh::Corner& corner : mesh.triangles[static_cast<std::size_t>(primitive.part)]) {
        result.push_back(mesh.vertices[static_cast<std::size_t>(corner.vertex)]);
    }
    return result;
}

/// How far the computed unit normal of a planar shape may be off, in units of roundoff: the
/// rounded edges, their cross products and their sum, in lengths of the area that is left.
double normal_condition(const std::vector<Vec>& vertices) {
    double edges = 0;
    Vec area(0, 0, 0);
    for (std::size_t k = 1; k + 1 < vertices.size(); ++k) {
        const Vec a = vertices[k] - vertices[0], b = vertices[k + 1] - vertices[0];
        edges += length(a) * length(b);
        area += outer(a, b);
    }
    const double left = length(area);
    return left > 0 ? 4 + 8 * edges / left : 1e300;
}

/// The factor by which a transform may enlarge errors: its condition number, by Frobenius norms.
double condition_of(const Object& object) {
    if (!object.transform) {
        return 1;
    }
    const Affine& m = *object.transform;
    const Vec columns[3] = {
        {m[0][0], m[1][0], m[2][0]}, {m[0][1], m[1][1], m[2][1]}, {m[0][2], m[1][2], m[2][2]}};
    double forward = 0, back = 0;
    const double determinant = inner(columns[0], outer(columns[1], columns[2]));
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec row = outer(columns[(k + 1) % 3], columns[(k + 2) % 3]) / determinant;
        forward += inner(columns[k], columns[k]);
        back += inner(row, row);
    }
    return 8 * std::sqrt(forward * back);
}

double reach_of(const Box& box) {
    return std::max(largest_component(box.min), largest_component(box.max));
}

}  // namespace

ShapeRounding rounding_of(const World<Quad>& reference, PrimitiveId id, const Vec& origin, double t,
                          double unit_roundoff) {
    const ShapeSet<Quad>& shapes = reference.shapes.shapes();
    const Primitive& primitive = shapes[id];
    const Object& object = reference.scene().objects[primitive.object];
    const Box box = shapes.bounds(id);
    const double extent = length(box.size());
    const double away = length<double>(origin - box.center()) + extent;
    const double reach = reach_of(box);
    const double condition = condition_of(object);
    const bool transformed = object.transform.has_value();
    const double seen_from = transformed ? away + reach + length(origin) : away;
    ShapeRounding result;
    const bool planar =
        primitive.kind == ShapeKind::polygon || primitive.kind == ShapeKind::triangle;
    if (planar) {
        result.normal =
            unit_roundoff * condition * normal_condition(vertices_of(object, primitive));
        result.distance =
            condition * unit_roundoff * (8 * seen_from + 4 * reach) + result.normal * extent;
    } else {
        const bool cone = primitive.kind == ShapeKind::cone;
        result.normal = unit_roundoff * condition * 16;
        result.distance =
            condition * unit_roundoff * ((cone ? 64 : 16) * seen_from + (cone ? 16 : 0) * reach);
    }
    result.point = condition * unit_roundoff * (4 * reach + 4 * extent + 2 * seen_from + 2 * t);
    return result;
}

}  // namespace raytree
