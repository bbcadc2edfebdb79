#include <array>
#include <limits>

#include "scene/planarity.h"
#include "scene/range_check.h"

namespace raytree {
namespace {

/// A determinant of rows (or columns) of length 1 below this is what rounding leaves of 0.
constexpr double kSingular = 16 * std::numeric_limits<double>::epsilon();

/// The determinant of a 3 x 3 matrix after each of its rows is scaled to length 1; 0 where it has a
/// row of length 0.
double scaled_determinant(const std::array<Point, 3>& rows) {
    std::array<Point, 3> unit;
    for (std::size_t k = 0; k < 3; ++k) {
        const double largest = largest_component(rows[k]);
        // The inverse has the reciprocals of the lengths, which are to be finite as well.
        if (!(largest > 0) || !isfinite(1 / largest)) {
            return 0;
        }
        unit[k] = UnitVec3<double>::of(rows[k]).vec();
    }
    return inner(unit[0], outer(unit[1], unit[2]));
}

bool is_invertible(const Affine& m) {
    std::array<Point, 3> rows;
    std::array<Point, 3> columns;
    for (std::size_t k = 0; k < 3; ++k) {
        rows[k] = {m[k][0], m[k][1], m[k][2]};
        columns[k] = {m[0][k], m[1][k], m[2][k]};
    }
    // Scaling the rows leaves a matrix as invertible as it is, and so does scaling the columns; the
    // better of the two says how far its worst scales hide that.
    return max_of(abs(scaled_determinant(rows)), abs(scaled_determinant(columns))) > kSingular;
}

void check_transform(const Affine& m, const JsonPlace& at, RangeCheck& check) {
    for (const auto& row : m) {
        for (const double number : row) {
            if (!isfinite(number)) {
                check.add(at, "must be finite numbers");
                return;
            }
        }
    }
    if (!is_invertible(m)) {
        check.add(at, "is singular: it flattens the object; it must be invertible");
    }
}

void check_shape(const Sphere& sphere, const JsonPlace& at, RangeCheck& check) {
    check.finite(at.member("center"), sphere.center);
    check.positive(at.member("radius"), sphere.radius);
}

void check_shape(const Cone& cone, const JsonPlace& at, RangeCheck& check) {
    const bool base = check.finite(at.member("base"), cone.base);
    const bool apex = check.finite(at.member("apex"), cone.apex);
    const bool base_radius = check.not_negative(at.member("base_radius"), cone.base_radius);
    const bool apex_radius = check.not_negative(at.member("apex_radius"), cone.apex_radius);
    if (base_radius && apex_radius && cone.base_radius == 0 && cone.apex_radius == 0) {
        check.add(at, "base_radius and apex_radius are both 0; one of them must be over 0");
    }
    if (base && apex && cone.base == cone.apex) {
        check.add(at, "base and apex are the same point; they must differ");
    }
}

void check_vertices(const std::vector<Point>& vertices, const JsonPlace& at, RangeCheck& check) {
    bool finite = true;
    for (std::size_t k = 0; k < vertices.size(); ++k) {
        finite &= check.finite(at.element(k), vertices[k]);
    }
    if (vertices.size() < 3) {
        check.add(at, "found " + std::to_string(vertices.size()) + " vertices, must be 3 or more");
        return;
    }
    if (!finite) {
        return;
    }
    const Planarity planarity = planarity_of(vertices);
    if (!planarity.has_area()) {
        check.add(at,
                  "the vertices are collinear, or the polygon has no area; they must span a "
                  "plane");
    } else if (!planarity.is_planar()) {
        check.add(at, "the vertices are not planar: one is off their plane by " +
                          shown_number(planarity.off_plane) +
                          " of the polygon's extent, must be at most 1e-06");
    }
}

void check_shape(const Polygon& polygon, const JsonPlace& at, RangeCheck& check) {
    check_vertices(polygon.vertices, at.member("vertices"), check);
    const JsonPlace normals = at.member("normals");
    if (!polygon.normals.empty() && polygon.normals.size() != polygon.vertices.size()) {
        check.add(normals, "found " + std::to_string(polygon.normals.size()) + " normals for " +
                               std::to_string(polygon.vertices.size()) +
                               " vertices, must be one for each vertex");
    }
    for (std::size_t k = 0; k < polygon.normals.size(); ++k) {
        check.direction(normals.element(k), polygon.normals[k]);
    }
}

bool in_range(int index, std::size_t count) {
    return index >= 0 && static_cast<std::size_t>(index) < count;
}

/// A mesh has no pointers to its parts: those are in a file of their own, whose reader names lines.
void check_shape(const Mesh& mesh, const JsonPlace& at, RangeCheck& check) {
    const JsonPlace file = at.member("file");
    bool finite = true;
    for (const Point& vertex : mesh.vertices) {
        finite = finite && check.finite(file, vertex);
    }
    for (const Point& normal : mesh.normals) {
        finite = finite && check.finite(file, normal);
    }
    if (mesh.triangles.empty()) {
        check.add(file, "the mesh has no triangle, must have at least one");
    }
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
        for (const Mesh::Corner& corner : mesh.triangles[k]) {
            if (!in_range(corner.vertex, mesh.vertices.size()) ||
                (corner.normal != -1 && !in_range(corner.normal, mesh.normals.size()))) {
                check.add(file, "triangle " + std::to_string(k) +
                                    " of the mesh has a vertex or normal that is not there");
                return;
            }
        }
    }
}

}  // namespace

void check_object(const Object& object, const JsonPlace& place, RangeCheck& check) {
    if (object.transform) {
        check_transform(*object.transform, place.member("transform"), check);
    }
    std::visit([&](const auto& shape) { check_shape(shape, place, check); }, object.shape);
}

}  // namespace raytree
