#include <cctype>
#include <cmath>
#include <utility>

#include "formats/course_text.h"
#include "formats/scene_losses.h"

namespace raytree {
namespace {

/// From the world to the format's own place of the camera: at the origin, looking down -z, up +y.
Placement to_eye_space(const Camera& camera) {
    const Point forward = UnitVec3<double>::of(camera.look_at - camera.eye).vec();
    const Point right = UnitVec3<double>::of(outer(forward, camera.up)).vec();
    Placement placement;
    placement.rows = {right, outer(right, forward), -forward};
    placement.shift = Point(0) - placement.vector(camera.eye);
    return placement;
}

/// Names are words there.
std::string word_of_name(const std::string& name) {
    std::string word;
    for (const char c : name) {
        word += std::isspace(static_cast<unsigned char>(c)) != 0 ? '_' : c;
    }
    return word.empty() ? "_" : word;
}

class CourseWriter {
  public:
    CourseWriter(const Scene& scene, std::vector<std::string>& lost)
        : scene_(scene), lost_(lost), to_eye_(to_eye_space(scene.camera)) {}

    std::string write(const std::string& output);

  private:
    void camera();
    void object(const Object& object);
    void light(const Light& light);
    void lose_material_parts(const Material& material);
    std::optional<Point> axes(const Placement& unit_sphere) const;

    const Scene& scene_;
    std::vector<std::string>& lost_;
    Placement to_eye_;
    std::string out_;
};

std::string CourseWriter::write(const std::string& output) {
    Settings implied;
    implied.max_depth = 4;
    implied.min_weight = 0;
    implied.pixel_sample = PixelSample::corner;
    implied.secondary_background = Colour(0.0);
    implied.quantize = Quantize::floor;
    add_lost_settings(scene_.settings, implied, "course text format", lost_);
    camera();
    for (const Object& each : scene_.objects) {
        object(each);
    }
    for (const Light& each : scene_.lights) {
        light(each);
    }
    out_ += "BACK";
    append_colour(out_, scene_.background);
    out_ += "\nAMBIENT";
    append_colour(out_, scene_.ambient);
    out_ += "\nOUTPUT " + word_of_name(output) + '\n';
    return std::move(out_);
}

void CourseWriter::camera() {
    const Camera& camera = scene_.camera;
    ImagePlane plane;
    if (const auto* fov = std::get_if<HorizontalFov>(&camera.window)) {
        const double half = std::tan(fov->degrees / 2 * (Real<double>::pi / 180));
        const double half_height = half * camera.height / camera.width;
        plane = {-half, half, -half_height, half_height};
    } else {
        plane = std::get<ImagePlane>(camera.window);
    }
    double near = camera.near;
    if (near == 0) {
        near = 1.0 / (1 << 20);  // a power of 2: the window is scaled by it without rounding
        lost_.push_back(
            "The near plane there is not at 0; what lies closer to the eye than "
            "0.000001 is cut off.");
    }
    const auto line = [&](const char* name, double value) {
        out_ += name;
        append_numbers(out_, {value});
        out_ += '\n';
    };
    line("NEAR", near);
    line("LEFT", plane.left * near);
    line("RIGHT", plane.right * near);
    line("BOTTOM", plane.bottom * near);
    line("TOP", plane.top * near);
    out_ += "RES " + std::to_string(camera.width) + ' ' + std::to_string(camera.height) + '\n';
}

/// The half axes of what becomes of the unit sphere, where they lie along x, y and z.
std::optional<Point> CourseWriter::axes(const Placement& unit_sphere) const {
    constexpr double rounding = 1e-12;
    const auto& rows = unit_sphere.rows;
    const Point lengths{length(rows[0]), length(rows[1]), length(rows[2])};
    // An ellipsoid M S is known by M M^T, whose eigenvectors are its axes.
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const double product =
            inner(rows[static_cast<std::size_t>(i)], rows[static_cast<std::size_t>(j)]);
        if (abs(product) > rounding * lengths[i] * lengths[j]) {
            return std::nullopt;
        }
    }
    return lengths;
}

void CourseWriter::object(const Object& object) {
    const auto* sphere = std::get_if<Sphere>(&object.shape);
    if (sphere == nullptr) {
        lost_.push_back("Only spheres exist there; " + object.name + " is left out.");
        return;
    }
    Placement unit;
    for (int k = 0; k < 3; ++k) {
        unit.rows[static_cast<std::size_t>(k)][k] = sphere->radius;
    }
    unit.shift = sphere->center;
    const Placement placed = chained(chained(unit, Placement::of(object)), to_eye_);
    const std::optional<Point> scale = axes(placed);
    if (!scale) {
        lost_.push_back("Stretched spheres are not turned there; " + object.name + " is left out.");
        return;
    }
    const Material& material = scene_.materials[object.material];
    const std::string of = " of " + object.name;
    lose_material_parts(material);
    out_ += "SPHERE " + word_of_name(object.name);
    append_point(out_, placed.shift);
    append_point(out_, *scale);
    append_colour(out_, material.color);
    append_numbers(
        out_, {only_grey(material.ka, "Ka" + of, lost_), only_grey(material.kd, "Kd" + of, lost_),
               only_grey(material.ks, "Ks" + of, lost_), only_grey(material.kr, "Kr" + of, lost_),
               material.shininess});
    out_ += '\n';
}

void CourseWriter::lose_material_parts(const Material& material) {
    if (!is_zero(material.kt)) {
        lost_.push_back("Nothing is transparent there; kt of the material " + material.name +
                        " is left out.");
    }
    if (!is_zero(material.ks) && !(material.specular_color == Colour(1.0))) {
        lost_.push_back("Highlights are white there; specular_color of the material " +
                        material.name + " is left out.");
    }
}

void CourseWriter::light(const Light& light) {
    const auto* point = std::get_if<PointLight>(&light.kind);
    if (point == nullptr) {
        lost_.push_back("Directional lights do not exist there; " + light.name + " is left out.");
        return;
    }
    if (!(point->attenuation == Attenuation{})) {
        lost_.push_back("Lights are not attenuated there; that of " + light.name + " is left out.");
    }
    out_ += "LIGHT " + word_of_name(light.name);
    append_point(out_, to_eye_.point(point->position));
    append_colour(out_, light.intensity);
    out_ += '\n';
}

}  // namespace

std::string write_course_text(const Scene& scene, const std::string& output,
                              std::vector<std::string>& lost) {
    return CourseWriter(scene, lost).write(output);
}

}  // namespace raytree
