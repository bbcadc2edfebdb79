#include "drawing/scene_mesh.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>

#include "drawing/coat.h"
#include "drawing/ground.h"
#include "drawing/polygon_fill.h"
#include "drawing/thinned_mesh.h"
#include "geometry/affine_map.h"
#include "geometry/plane.h"

namespace raytree::inspector {
namespace {

constexpr double triangle_budget = 120'000;
constexpr double mesh_budget = 40'000;  // triangles of all meshes, which have no fewer from afar
constexpr double most_slices = 90;      // of a round shape
constexpr int tiny_slices = 6;          // of a ball that is a few pixels large

/// See SceneMesh. `firmness` from 0 to 1.
std::uint8_t alpha_of(double firmness, bool flat) {
    return static_cast<std::uint8_t>(std::lround(127 * firmness) + (flat ? 128 : 0));
}

class Builder {
  public:
    Builder(const Document& document, const Extent& extent, double pixel)
        : scene_(document.scene()), extent_(extent), pixel_(pixel), ground_(extent) {
        choose_resolution();
    }

    SceneMesh build() {
        for (const Object& object : scene_.objects) {
            add(object);
        }
        return std::move(mesh_);
    }

  private:
    /// Round shapes get as many facets as fit into the budget for all.
    void choose_resolution() {
        double wanted = 1, meshed = 1;
        for (const Object& object : scene_.objects) {
            const double n = slices_of(object);
            wanted += n * n;
            if (const auto* mesh = std::get_if<raytree::Mesh>(&object.shape)) {
                meshed += static_cast<double>(mesh->triangles.size());
            }
        }
        finer_ = std::min(1.0, std::sqrt(triangle_budget / wanted));
        mesh_share_ = std::min(1.0, mesh_budget / meshed);
        mesh_.thinned_from = mesh_share_ < 1 ? static_cast<std::size_t>(meshed) - 1 : 0;
    }

    int slices_of(const Object& object) const {
        double radius = 0;
        if (const auto* sphere = std::get_if<Sphere>(&object.shape)) {
            radius = sphere->radius;
        } else if (const auto* cone = std::get_if<Cone>(&object.shape)) {
            radius = std::max(cone->base_radius, cone->apex_radius);
        } else {
            return 0;
        }
        // A chord leaves its arc by no more than a quarter of a pixel: r (1 - cos(pi / n)).
        const double pixels = (object.transform ? 0.1 * extent_.diagonal : radius) / pixel_;
        const double wanted = std::clamp(4.5 * std::sqrt(pixels), 4.0, most_slices);
        return std::max(4, static_cast<int>(finer_ * wanted));
    }

    void add(const Object& object) {
        map_.reset();
        if (object.transform) {
            map_.emplace(*object.transform);
        }
        const Coat coat = coat_of(scene_.materials[object.material]);
        const bool flat = std::holds_alternative<Polygon>(object.shape);
        const int slices = slices_of(object);
        const bool tiny = std::holds_alternative<Sphere>(object.shape) && slices <= tiny_slices;
        // One side is as firm as both of them behind each other.
        firmness_ = tiny ? 1 - std::pow(1 - coat.firmness, 2) : coat.firmness;
        paint_ = {coat.ink, alpha_of(firmness_, flat)};
        line_ = {mixed(paint_.ink, Ink(0x5A6673), 0.55), 150};
        ObjectFaces faces;
        faces.tiny = tiny;
        faces.object = static_cast<std::size_t>(&object - scene_.objects.data());
        faces.first = mesh_.faces.triangle_count();
        faces.first_wire = mesh_.wires.segments.size() / 2;
        const std::size_t first_point = mesh_.faces.points.size();
        std::visit([&](const auto& shape) { add_shape(shape, slices); }, object.shape);
        faces.count = mesh_.faces.triangle_count() - faces.first;
        faces.wires = mesh_.wires.segments.size() / 2 - faces.first_wire;
        if (faces.count == 0) {
            return;
        }
        faces.first_point = first_point / 3;
        faces.points = mesh_.faces.points.size() / 3 - faces.first_point;
        measure(faces, first_point, flat);
        mesh_.objects.push_back(faces);
    }

    void measure(ObjectFaces& faces, std::size_t first_point, bool is_polygon) const {
        const auto& points = mesh_.faces.points;
        const auto at = [&](std::size_t k) {
            return Point3(points[k], points[k + 1], points[k + 2]);
        };
        Span3 box{at(first_point), at(first_point)};
        for (std::size_t k = first_point; k < points.size(); k += 3) {
            box.add(at(k));
        }
        faces.centre = box.centre();
        faces.radius = 0.5 * box.diagonal();
        faces.flat = is_polygon && box.diagonal() > 0.6 * extent_.diagonal;
        const auto& normals = mesh_.faces.normals;
        faces.normal = {normals[first_point], normals[first_point + 1], normals[first_point + 2]};
    }

    Point3 to_world(const Point3& p) const { return map_ ? map_->point_to_world(p) : p; }
    Point3 normal_to_world(const Point3& n) const {
        return map_ ? map_->normal_to_world(UnitVec3<double>::of(n)).vec() : glm::normalize(n);
    }

    std::int32_t add_point(const Point3& p, const Point3& normal) {
        return mesh_.faces.add_point(to_world(p), normal_to_world(normal), paint_);
    }

    /// A grid of facets over (0..columns, 0..rows), closed along its columns. `at` gives the point
    /// and the normal of a corner. Where the first and the last row are single points (`poles`),
    /// facets without an area are left out.
    template <class At> void add_surface(int columns, int rows, int wire_every, bool poles, At at) {
        const auto first = static_cast<std::int32_t>(mesh_.faces.points.size() / 3);
        for (int row = 0; row <= rows; ++row) {
            for (int column = 0; column < columns; ++column) {
                const auto [p, n] = at(column, row);
                add_point(p, n);
            }
        }
        const auto corner = [&](int column, int row) {
            return first + row * columns + column % columns;
        };
        for (int row = 0; row < rows; ++row) {
            for (int column = 0; column < columns; ++column) {
                const std::int32_t a = corner(column, row), b = corner(column + 1, row);
                const std::int32_t c = corner(column + 1, row + 1), d = corner(column, row + 1);
                if (!poles || row > 0) {
                    mesh_.faces.add_triangle(a, b, c);
                }
                if (!poles || row + 1 < rows) {
                    mesh_.faces.add_triangle(a, c, d);
                }
            }
        }
        add_wires(first, columns, rows, wire_every);
    }

    void add_wires(std::int32_t first, int columns, int rows, int every) {
        const auto base = static_cast<std::int32_t>(mesh_.wires.points.size() / 3);
        const auto& points = mesh_.faces.points;
        for (auto k = static_cast<std::size_t>(first) * 3; k < points.size(); k += 3) {
            mesh_.wires.add_point({points[k], points[k + 1], points[k + 2]}, line_);
        }
        const auto join = [&](int c0, int r0, int c1, int r1) {
            const auto place = [&](int c, int r) { return base + r * columns + c % columns; };
            mesh_.wires.segments.insert(mesh_.wires.segments.end(), {place(c0, r0), place(c1, r1)});
        };
        for (int row = 0; row <= rows; row += every) {
            for (int column = 0; column < columns; ++column) {
                join(column, row, column + 1, row);
            }
        }
        for (int column = 0; column < columns; column += every) {
            for (int row = 0; row < rows; ++row) {
                join(column, row, column, row + 1);
            }
        }
    }

    void add_shape(const Sphere& sphere, int slices) {
        const int stacks = std::max(2, slices / 2);
        add_surface(slices, stacks, std::max(1, slices / 12), true, [&](int column, int row) {
            const double around = 2 * std::numbers::pi * column / slices;
            const double polar = std::numbers::pi * row / stacks;
            const Point3 out(std::sin(polar) * std::cos(around), std::cos(polar),
                             std::sin(polar) * std::sin(around));
            return std::pair(sphere.center + sphere.radius * out, out);
        });
    }

    void add_shape(const Cone& cone, int slices) {
        const Point3 way = cone.apex - cone.base;
        const double height = glm::length(way);
        const Point3 axis = way / height;
        const Across axes = across(axis);
        const double slope = (cone.base_radius - cone.apex_radius) / height;
        add_surface(slices, 1, std::max(1, slices / 12), false, [&](int column, int row) {
            const double around = 2 * std::numbers::pi * column / slices;
            const Point3 out = std::cos(around) * axes.u + std::sin(around) * axes.v;
            const Point3 middle = row == 0 ? cone.base : cone.apex;
            const double radius = row == 0 ? cone.base_radius : cone.apex_radius;
            return std::pair(middle + radius * out, out + slope * axis);
        });
    }

    void add_shape(const Polygon& polygon, int) {
        const Point3 normal = normal_to_world(newell_normal<double>(polygon.vertices));
        for (const auto& triangle : filled(polygon)) {
            add_facet(triangle, normal);
        }
        const std::size_t n = polygon.vertices.size();
        for (std::size_t k = 0; k < n; ++k) {
            const Point3 a = to_world(polygon.vertices[k]);
            const Point3 b = to_world(polygon.vertices[(k + 1) % n]);
            add_edge(a, b);
        }
    }

    /// What goes on far beyond the view fades out around it.
    void add_facet(const std::array<Point3, 3>& local, const Point3& normal) {
        const Ground::Triangle corners{to_world(local[0]), to_world(local[1]), to_world(local[2])};
        if (ground_.is_firm(corners)) {
            add_triangle(corners, normal);
            return;
        }
        for (const Ground::Triangle& facet : ground_.facets(corners, normal)) {
            add_triangle(facet, normal);
        }
        for (const auto& [from, to] : ground_.grid(corners, normal)) {
            mesh_.wires.add(from, fading_line(from), to, fading_line(to));
        }
    }

    void add_edge(const Point3& a, const Point3& b) {
        for (const auto& [from, to] : ground_.pieces(a, b)) {
            for (Lines* const lines : {&mesh_.edges, &mesh_.wires}) {
                lines->add(from, fading_line(from), to, fading_line(to));
            }
        }
    }

    Paint fading_line(const Point3& p) const {
        return {line_.ink, static_cast<std::uint8_t>(line_.alpha * ground_.firmness(p))};
    }

    void add_triangle(const Ground::Triangle& corners, const Point3& normal) {
        std::array<std::int32_t, 3> places{};
        std::ranges::transform(corners, places.begin(), [&](const Point3& p) {
            const std::uint8_t alpha = alpha_of(firmness_ * ground_.firmness(p), true);
            return mesh_.faces.add_point(p, normal, {paint_.ink, alpha});
        });
        mesh_.faces.add_triangle(places[0], places[1], places[2]);
    }

    void add_shape(const raytree::Mesh& mesh, int) {
        const auto most =
            static_cast<std::size_t>(mesh_share_ * static_cast<double>(mesh.triangles.size()));
        if (mesh_share_ < 1) {
            add_triangles(thinned(mesh, most));
        } else {
            add_triangles(mesh);
        }
    }

    void add_triangles(const raytree::Mesh& mesh) {
        for (const auto& triangle : mesh.triangles) {
            std::array<Point3, 3> p;
            for (std::size_t k = 0; k < 3; ++k) {
                p[k] = mesh.vertices[static_cast<std::size_t>(triangle[k].vertex)];
            }
            const Point3 flat = glm::cross(p[1] - p[0], p[2] - p[0]);
            if (!(glm::length(flat) > 0)) {
                continue;
            }
            std::array<std::int32_t, 3> place;
            for (std::size_t k = 0; k < 3; ++k) {
                const int normal = triangle[k].normal;
                place[k] = add_point(
                    p[k], normal < 0 ? flat : mesh.normals[static_cast<std::size_t>(normal)]);
                mesh_.wires.add(to_world(p[k]), to_world(p[(k + 1) % 3]), line_);
            }
            mesh_.faces.add_triangle(place[0], place[1], place[2]);
        }
    }

    const Scene& scene_;
    const Extent& extent_;
    double pixel_;
    Ground ground_;
    double finer_ = 1;
    double mesh_share_ = 1;
    SceneMesh mesh_;
    std::optional<AffineMap<double>> map_;
    double firmness_ = 1;
    Paint paint_, line_;
};

}  // namespace

SceneMesh scene_mesh(const Document& document, const Extent& extent, double pixel) {
    return Builder(document, extent, pixel).build();
}

double mesh_pixel(const Extent& extent, const View& view) {
    const double pixels = extent.diagonal / length_per_pixel(view, extent.seen.centre());
    return extent.diagonal / std::exp2(std::ceil(std::log2(std::clamp(pixels, 64.0, 65536.0))));
}

}  // namespace raytree::inspector
