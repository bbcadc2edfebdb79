#include <cmath>
#include <cstddef>
#include <optional>

#include "formats/nff.h"
#include "formats/scene_losses.h"

namespace raytree {
namespace {

class NffWriter {
  public:
    NffWriter(const Scene& scene, std::vector<std::string>& lost) : scene_(scene), lost_(lost) {}

    std::string write();

  private:
    void view();
    double half_height();
    void lights();
    void material(const Material& material);
    Colour diffuse_colour(const Material& material, double& kd);
    void object(const Object& object);
    void shape(const Object& object, const Placement& to_world, const Sphere& sphere);
    void shape(const Object& object, const Placement& to_world, const Cone& cone);
    void shape(const Object& object, const Placement& to_world, const Polygon& polygon);
    void shape(const Object& object, const Placement& to_world, const Mesh& mesh);
    void polygon(const std::vector<Point>& vertices, const std::vector<Point>& normals,
                 const Placement& to_world);
    bool has_scale(const Object& object, double scale);

    const Scene& scene_;
    std::vector<std::string>& lost_;
    std::string out_;
    std::optional<std::size_t> written_material_;
};

std::string NffWriter::write() {
    Settings implied;
    implied.max_depth = 5;
    implied.min_weight = 0;
    add_lost_settings(scene_.settings, implied, "Neutral File Format", lost_);
    out_ = "b";
    append_colour(out_, scene_.background);
    out_ += '\n';
    view();
    lights();
    for (const Object& each : scene_.objects) {
        object(each);
    }
    return std::move(out_);
}

void NffWriter::view() {
    const Camera& camera = scene_.camera;
    const auto line = [&](const char* name) { out_ += name; };
    line("v\nfrom");
    append_point(out_, camera.eye);
    line("\nat");
    append_point(out_, camera.look_at);
    line("\nup");
    append_point(out_, camera.up);
    line("\nangle");
    const double rows = camera.height;
    double angle = 2 * std::atan(half_height() * (rows - 1) / rows) * 180 / Real<double>::pi;
    if (camera.height == 1) {
        lost_.push_back("A picture of one row has no angle there; an angle of 45 is written.");
        angle = 45;
    }
    append_numbers(out_, {angle});
    line("\nhither");
    append_numbers(out_, {camera.near});
    line("\nresolution");
    append_numbers(out_, {static_cast<double>(camera.width), rows});
    out_ += '\n';
}

/// Of the window at distance 1. The format's window is around the view and its pixels are square.
double NffWriter::half_height() {
    const Camera& camera = scene_.camera;
    const double ratio = static_cast<double>(camera.height) / camera.width;
    if (const auto* fov = std::get_if<HorizontalFov>(&camera.window)) {
        return std::tan(fov->degrees / 2 * (Real<double>::pi / 180)) * ratio;
    }
    const auto& plane = std::get<ImagePlane>(camera.window);
    constexpr double rounding = 1e-12;
    const double width = plane.right - plane.left;
    const double height = plane.top - plane.bottom;
    const bool centred = abs(plane.left + plane.right) <= rounding * width &&
                         abs(plane.bottom + plane.top) <= rounding * height;
    if (!centred || abs(height - width * ratio) > rounding * height) {
        lost_.push_back(
            "The image plane there is centred on the view and has square pixels; one of "
            "the same height is written.");
    }
    return height / 2;
}

void NffWriter::lights() {
    for (const Light& light : scene_.lights) {
        const auto* point = std::get_if<PointLight>(&light.kind);
        if (point == nullptr) {
            lost_.push_back("Directional lights do not exist there; " + light.name +
                            " is left out.");
            continue;
        }
        if (!(point->attenuation == Attenuation{})) {
            lost_.push_back("Lights are not attenuated there; that of " + light.name +
                            " is left out.");
        }
        out_ += 'l';
        append_point(out_, point->position);
        append_colour(out_, light.intensity);
        out_ += '\n';
    }
}

/// The format has one Kd: where ours has three, they are taken into the colour, which then says the
/// same, since there is no ambient light.
Colour NffWriter::diffuse_colour(const Material& material, double& kd) {
    if (is_one_number(material.kd)) {
        kd = material.kd.r;
        return material.color;
    }
    kd = 1;
    return material.color * material.kd;
}

void NffWriter::material(const Material& material) {
    const std::string of = " of the material " + material.name;
    double kd = 0;
    const Colour colour = diffuse_colour(material, kd);
    const bool shines = !is_zero(material.ks);
    const double ks = only_grey(material.kr, "kr" + of, lost_);
    if (!(material.ks == material.kr)) {
        lost_.push_back("ks and kr are one number there; ks" + of + " becomes its kr.");
    }
    if (shines && !(material.specular_color == Colour(1.0))) {
        lost_.push_back("Highlights are white there; specular_color" + of + " is left out.");
    }
    if (!is_zero(material.ka * material.color * scene_.ambient)) {
        lost_.push_back("There is no ambient light there; ka" + of + " is left out.");
    }
    out_ += 'f';
    append_colour(out_, colour);
    append_numbers(
        out_, {kd, ks, material.shininess, only_grey(material.kt, "kt" + of, lost_), material.ior});
    out_ += '\n';
}

void NffWriter::object(const Object& object) {
    if (written_material_ != object.material) {
        material(scene_.materials[object.material]);
        written_material_ = object.material;
    }
    std::visit([&](const auto& s) { shape(object, Placement::of(object), s); }, object.shape);
}

bool NffWriter::has_scale(const Object& object, double scale) {
    if (scale == 0) {
        lost_.push_back("Spheres and cones are not stretched there; " + object.name +
                        " is left out.");
    }
    return scale > 0;
}

void NffWriter::shape(const Object& object, const Placement& to_world, const Sphere& sphere) {
    const double scale = to_world.uniform_scale();
    if (has_scale(object, scale)) {
        out_ += 's';
        append_point(out_, to_world.point(sphere.center));
        append_numbers(out_, {sphere.radius * scale});
        out_ += '\n';
    }
}

void NffWriter::shape(const Object& object, const Placement& to_world, const Cone& cone) {
    const double scale = to_world.uniform_scale();
    if (has_scale(object, scale)) {
        out_ += 'c';
        append_point(out_, to_world.point(cone.base));
        append_numbers(out_, {cone.base_radius * scale});
        append_point(out_, to_world.point(cone.apex));
        append_numbers(out_, {cone.apex_radius * scale});
        out_ += '\n';
    }
}

void NffWriter::shape(const Object& /*object*/, const Placement& to_world, const Polygon& shape) {
    polygon(shape.vertices, shape.normals, to_world);
}

void NffWriter::shape(const Object& object, const Placement& to_world, const Mesh& mesh) {
    lost_.push_back("Meshes do not exist there; " + object.name + " becomes " +
                    std::to_string(mesh.triangles.size()) + " polygons.");
    for (const Mesh::Triangle& triangle : mesh.triangles) {
        std::vector<Point> vertices;
        std::vector<Point> normals;
        for (const Mesh::Corner& corner : triangle) {
            vertices.push_back(mesh.vertices[static_cast<std::size_t>(corner.vertex)]);
            if (mesh.smooth && corner.normal >= 0) {
                normals.push_back(mesh.normals[static_cast<std::size_t>(corner.normal)]);
            }
        }
        polygon(vertices, normals, to_world);
    }
}

void NffWriter::polygon(const std::vector<Point>& vertices, const std::vector<Point>& normals,
                        const Placement& to_world) {
    out_ += (normals.empty() ? "p " : "pp ") + std::to_string(vertices.size()) + '\n';
    for (std::size_t k = 0; k < vertices.size(); ++k) {
        std::string line;
        append_point(line, to_world.point(vertices[k]));
        if (!normals.empty()) {
            append_point(line, to_world.normal(normals[k]));
        }
        out_ += line.substr(1) + '\n';
    }
}

}  // namespace

std::string write_nff(const Scene& scene, std::vector<std::string>& lost) {
    return NffWriter(scene, lost).write();
}

}  // namespace raytree
