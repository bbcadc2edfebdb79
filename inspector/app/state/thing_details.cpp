#include "state/thing_details.h"

#include <array>
#include <glm/common.hpp>

#include "formats/tree_diagram.h"
#include "state/detail_rows.h"
#include "state/numbers.h"
#include "state/table.h"
#include "tree/explain.h"

namespace raytree::inspector {
namespace {

using Row = DetailRow;
using Weight = DetailRow::Weight;

Row colour_row(std::string label, const Rgb<double>& c, bool swatch = false) {
    Row row = triple_row(std::move(label), c);
    if (swatch) {
        row.swatch = c;
    }
    return row;
}
void add(std::vector<Row>& rows, const Sphere& sphere) {
    rows.push_back(text_row("shape", "sphere"));
    rows.push_back(heading_row({"x", "y", "z"}));
    rows.push_back(triple_row("centre c", sphere.center));
    rows.push_back(number_row("radius r", sphere.radius));
}

void add(std::vector<Row>& rows, const Cone& cone) {
    const bool cylinder = cone.base_radius == cone.apex_radius;
    const bool pointed = cone.base_radius == 0 || cone.apex_radius == 0;
    rows.push_back(text_row("shape", std::string(cylinder  ? "cylinder"
                                                 : pointed ? "cone"
                                                           : "frustum of a cone") +
                                         ", open at both ends"));
    rows.push_back(heading_row({"x", "y", "z"}));
    rows.push_back(triple_row("base", cone.base));
    rows.push_back(triple_row("apex", cone.apex));
    rows.push_back(number_row("radius at base", cone.base_radius));
    rows.push_back(number_row("radius at apex", cone.apex_radius));
}

void add(std::vector<Row>& rows, const Polygon& polygon) {
    constexpr std::size_t most_vertices = 12;
    const std::size_t n = polygon.vertices.size();
    rows.push_back(text_row("shape", "polygon of " + std::to_string(n) + " vertices" +
                                         (polygon.normals.empty() ? "" : ", with normals")));
    rows.push_back(heading_row({"x", "y", "z"}));
    for (std::size_t k = 0; k < std::min(n, most_vertices); ++k) {
        rows.push_back(triple_row("vertex " + std::to_string(k), polygon.vertices[k]));
    }
    if (n > most_vertices) {
        rows.push_back(text_row("", "and " + std::to_string(n - most_vertices) + " more"));
    }
}

void add(std::vector<Row>& rows, const Mesh& mesh) {
    const auto counted = [](std::size_t n, const std::string& one, const std::string& many) {
        return grouped(static_cast<double>(n)) + " " + (n == 1 ? one : many);
    };
    rows.push_back(text_row("shape", "mesh of " +
                                         counted(mesh.triangles.size(), "triangle", "triangles") +
                                         (mesh.smooth ? ", smooth" : ", flat")));
    rows.push_back(text_row(
        "", counted(mesh.vertices.size(), "vertex, ", "vertices, ") +
                (mesh.normals.empty() ? "no normals"
                                      : counted(mesh.normals.size(), "normal", "normals"))));
    if (!mesh.file.empty()) {
        rows.push_back(text_row("file", mesh.file));
    }
    if (!mesh.vertices.empty()) {
        Point low = mesh.vertices.front(), high = low;
        for (const Point& vertex : mesh.vertices) {
            low = glm::min(low, vertex);
            high = glm::max(high, vertex);
        }
        rows.push_back(heading_row({"x", "y", "z"}));
        rows.push_back(triple_row("from", low));
        rows.push_back(triple_row("to", high));
    }
}

DetailSection shape_of(const Object& object) {
    DetailSection section{"Shape", {}, {}};
    std::visit([&](const auto& shape) { add(section.rows, shape); }, object.shape);
    if (object.transform) {
        section.sentences.push_back(
            "In its own space: the transform below takes it into the "
            "scene.");
    }
    return section;
}

/// By where it takes the axes of the shape's own space and its origin: the columns of its matrix.
DetailSection transform_of(const Affine& transform) {
    DetailSection section{"Transform", {}, {}};
    auto& rows = section.rows;
    rows.push_back(heading_row({"x", "y", "z"}));
    const char* const labels[] = {"x axis goes to", "y axis goes to", "z axis goes to",
                                  "origin goes to"};
    for (std::size_t k = 0; k < 4; ++k) {
        rows.push_back(
            triple_row(labels[k], Vec3<double>(transform[0][k], transform[1][k], transform[2][k])));
    }
    return section;
}

DetailSection material_of(const Material& material) {
    DetailSection section{"Material", {}, {}};
    auto& rows = section.rows;
    if (!material.in_place && !material.name.empty()) {
        rows.push_back(text_row("name", material.name));
    }
    rows.push_back(heading_row({"red", "green", "blue"}));
    rows.push_back(colour_row("colour", material.color, true));
    rows.push_back(colour_row("ka ambient", material.ka));
    rows.push_back(colour_row("kd diffuse", material.kd));
    rows.push_back(colour_row("ks specular", material.ks));
    rows.push_back(colour_row("its colour", material.specular_color, true));
    rows.push_back(colour_row("kr reflected", material.kr));
    rows.push_back(colour_row("kt refracted", material.kt));
    rows.push_back(number_row("shininess", material.shininess));
    rows.push_back(number_row("η (ior)", material.ior));
    return section;
}

DetailSection light_of(const Light& light) {
    DetailSection section{"Light", {}, {}};
    auto& rows = section.rows;
    const auto* const point = std::get_if<PointLight>(&light.kind);
    rows.push_back(text_row("kind", point ? "point light" : "directional light"));
    rows.push_back(heading_row({"red", "green", "blue"}));
    rows.push_back(colour_row("intensity", light.intensity));
    rows.push_back(heading_row({"x", "y", "z"}));
    if (!point) {
        rows.push_back(triple_row("direction", std::get<DirectionalLight>(light.kind).direction));
        return section;
    }
    rows.push_back(triple_row("position", point->position));
    const auto& [a, b, c] = point->attenuation;
    if (point->attenuation != Attenuation{}) {
        rows.push_back(heading_row({"a", "b", "c"}));
        rows.push_back(
            {"attenuation", aligned(std::array{a, b, c}), Weight::normal, false, {}, {a, b, c}});
        section.sentences.push_back("It fades with the distance t by 1 / (a + b t + c t²).");
    }
    return section;
}

/// Each a line that leads to its ray.
DetailSection rays_of(const Scene& scene, const PixelTree& tree, Thing thing) {
    const bool light = thing.kind == Thing::Kind::light;
    auto rays = rays_that_concern(scene, tree.tree, thing);
    std::erase_if(rays, [&](std::size_t ray) { return !tree.is_own(ray); });
    DetailSection section{
        std::string(light ? "Shadow rays to it" : "Rays that meet it") + " in this pixel's tree",
        {},
        {}};
    for (std::size_t k = 0; k < std::min(rays.size(), most_listed); ++k) {
        const std::string t = text_of(tree, rays[k], Column::t);
        const std::string fate =
            light ? short_fate(tree.tree.rays[rays[k]]) : (t.empty() ? "" : "t = " + t);
        Row row = text_row(text_of(tree, rays[k], Column::ray), fate);
        row.rays = {rays[k]};
        section.rows.push_back(std::move(row));
    }
    if (rays.empty()) {
        section.sentences.push_back("None.");
    } else if (rays.size() > most_listed) {
        section.sentences.push_back("And " + std::to_string(rays.size() - most_listed) + " more.");
    }
    return section;
}

}  // namespace

std::string title_of(const Scene& scene, Thing thing) {
    return (thing.kind == Thing::Kind::light ? "light " : "object ") + name_of(scene, thing);
}

std::vector<DetailSection> details_of(const Scene& scene, const PixelTree* tree, Thing thing) {
    std::vector<DetailSection> sections;
    if (tree) {
        sections.push_back(rays_of(scene, *tree, thing));
    }
    if (thing.kind == Thing::Kind::light) {
        sections.push_back(light_of(scene.lights[thing.index]));
    } else {
        const Object& object = scene.objects[thing.index];
        sections.push_back(material_of(scene.materials[object.material]));
        sections.push_back(shape_of(object));
        if (object.transform) {
            sections.push_back(transform_of(*object.transform));
        }
    }
    return sections;
}

}  // namespace raytree::inspector
