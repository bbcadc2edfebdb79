#include "support/povray.h"

#include <sys/resource.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "formats/output_file.h"
#include "formats/split_polygon.h"
#include "support/bench.h"
#include "trace/camera_rays.h"

namespace raytree::bench {
namespace {

bool grey(const Rgb<double>& c) { return c.r == c.g && c.g == c.b; }

bool has_normals(const Object& object) {
    if (const auto* polygon = std::get_if<Polygon>(&object.shape)) {
        return !polygon->normals.empty();
    }
    const auto* mesh = std::get_if<Mesh>(&object.shape);
    return mesh && mesh->smooth && !mesh->normals.empty();
}

std::ostream& put(std::ostream& out, const Point& p) {
    return out << '<' << p.x << ',' << p.y << ',' << p.z << '>';
}
std::ostream& put(std::ostream& out, const Rgb<double>& c) {
    return out << "rgb<" << c.r << ',' << c.g << ',' << c.b << '>';
}

/// Colours are multiplied by the pigment there, so that ambient light is divided by it here.
double share(double part, double whole) { return whole > 0 ? part / whole : 0; }

void put_texture(std::ostream& out, const Scene& scene, const Material& m) {
    const Rgb<double> pigment = m.kd * m.color;
    const Rgb<double> ambient = m.ka * m.color * scene.ambient;
    out << " texture{pigment{color ";
    put(out, pigment);
    if (!is_zero(m.kt)) {
        out << " transmit " << (m.kt.r + m.kt.g + m.kt.b) / 3;
    }
    out << "} finish{diffuse 1 ambient ";
    put(out, Rgb<double>(share(ambient.r, pigment.r), share(ambient.g, pigment.g),
                         share(ambient.b, pigment.b)));
    out << " phong " << m.ks.r * m.specular_color.r << " phong_size " << m.shininess
        << " reflection{";
    put(out, m.kr) << "}}}";
    if (!is_zero(m.kt)) {
        out << " interior{ior " << m.ior << '}';
    }
}

void put_shape(std::ostream& out, const Shape& shape) {
    const auto triangle = [&](const Point& a, const Point& b, const Point& c) {
        out << "triangle{";
        put(put(put(out, a) << ',', b) << ',', c) << "}\n";
    };
    if (const auto* sphere = std::get_if<Sphere>(&shape)) {
        put(out << "sphere{", sphere->center) << ',' << sphere->radius;
    } else if (const auto* cone = std::get_if<Cone>(&shape)) {
        put(out << "cone{", cone->base) << ',' << cone->base_radius << ',';
        put(out, cone->apex) << ',' << cone->apex_radius << " open";
    } else if (const auto* polygon = std::get_if<Polygon>(&shape)) {
        out << "mesh{\n";
        for (const Polygon& part : split_into_triangles(*polygon)) {
            triangle(part.vertices[0], part.vertices[1], part.vertices[2]);
        }
    } else {
        const Mesh& mesh = std::get<Mesh>(shape);
        out << "mesh{\n";
        for (const Mesh::Triangle& corners : mesh.triangles) {
            const auto vertex = [&](std::size_t k) {
                return mesh.vertices[static_cast<std::size_t>(corners[k].vertex)];
            };
            triangle(vertex(0), vertex(1), vertex(2));
        }
    }
}

void put_camera(std::ostream& out, const Scene& scene) {
    const Camera& camera = scene.camera;
    const CameraRays<double> rays(camera, PixelSample::center);
    const double width = (rays.xp(1) - rays.xp(0)) * camera.width;
    const double height = (rays.yp(0) - rays.yp(1)) * camera.height;
    put(out << "camera{perspective location ", camera.eye) << " direction ";
    put(out, rays.forward().vec()) << " right ";
    put(out, width * rays.right().vec()) << " up ";
    put(out, height * rays.up()) << "}\n";
}

double children_seconds() {
    rusage usage{};
    getrusage(RUSAGE_CHILDREN, &usage);
    return static_cast<double>(usage.ru_utime.tv_sec) +
           1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

Picture read_ppm16(const std::string& bytes) {
    std::istringstream in(bytes);
    std::string magic;
    Picture picture;
    int most = 0;
    const auto number = [&](int& value) {  // lines that begin with # are remarks
        while ((in >> std::ws).peek() == '#') {
            in.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
        }
        in >> value;
    };
    in >> magic;
    number(picture.width);
    number(picture.height);
    number(most);
    in.get();
    if (magic != "P6" || most != 65535) {
        throw std::runtime_error("POV-Ray's picture is no PPM of 16 bits");
    }
    const auto channel = [&] {
        const int high = in.get();
        return static_cast<double>(high * 256 + in.get()) / most;
    };
    for (int k = 0; k < picture.width * picture.height; ++k) {
        const double r = channel(), g = channel();
        picture.pixels.push_back({r, g, channel()});
    }
    return picture;
}

/// Seconds of processor time.
double run_once(const std::filesystem::path& folder, int width, int height) {
    const std::string command =
        "cd '" + folder.string() + "' && povray +Iscene.pov +Opicture.ppm " +
        "+FP16 -D -A +WT1 -GA File_Gamma=1.0 Antialias=Off +W" + std::to_string(width) + " +H" +
        std::to_string(height) + " >log.txt 2>&1";
    const double before = children_seconds();
    if (std::system(command.c_str()) != 0) {
        throw std::runtime_error("POV-Ray failed: " + read_input((folder / "log.txt").string()));
    }
    return children_seconds() - before;
}

}  // namespace

std::string povray_why_not(const Scene& scene) {
    if (access("/usr/bin/povray", X_OK) != 0) {
        return "POV-Ray is not installed";
    }
    const Settings& settings = scene.settings;
    if (!(settings.attenuation == Attenuation{})) {
        return "POV-Ray does not attenuate reflected rays by distance";
    }
    if (settings.specular_model != SpecularModel::phong || settings.max_distance ||
        settings.shadows != ShadowMode::opaque || settings.secondary_background ||
        settings.pixel_sample != PixelSample::center || scene.camera.near > 0) {
        return "the settings have something that POV-Ray has not";
    }
    if (const auto* plane = std::get_if<ImagePlane>(&scene.camera.window);
        plane && (plane->left != -plane->right || plane->bottom != -plane->top)) {
        return "POV-Ray's window is about the view's axis";
    }
    for (const Light& light : scene.lights) {
        const auto* point = std::get_if<PointLight>(&light.kind);
        if (!point || !(point->attenuation == Attenuation{})) {
            return "POV-Ray has other formulas for lights that are far or get weaker";
        }
    }
    for (const Object& object : scene.objects) {
        const Material& m = scene.materials[object.material];
        if (!is_zero(m.kt)) {
            return "transparent surfaces throw other shadows in POV-Ray";
        }
        const Rgb<double> pigment = m.kd * m.color, ambient = m.ka * m.color * scene.ambient;
        if (!grey(m.ks * m.specular_color) || (pigment.r == 0 && ambient.r > 0) ||
            (pigment.g == 0 && ambient.g > 0) || (pigment.b == 0 && ambient.b > 0)) {
            return "POV-Ray's surfaces have no such colours";
        }
        if (has_normals(object)) {
            return "normals of vertices are interpolated otherwise in POV-Ray";
        }
    }
    return "";
}

std::string povray_text(const Scene& scene) {
    std::ostringstream out;
    out.precision(17);
    out << "#version 3.7;\nglobal_settings{assumed_gamma 1.0 max_trace_level "
        << scene.settings.max_depth << " adc_bailout " << scene.settings.min_weight
        << " ambient_light rgb 1}\nbackground{color ";
    put(out, scene.background) << "}\n";
    put_camera(out, scene);
    for (const Light& light : scene.lights) {
        put(out << "light_source{", std::get<PointLight>(light.kind).position) << ", color ";
        put(out, light.intensity) << "}\n";
    }
    for (const Object& object : scene.objects) {
        put_shape(out, object.shape);
        put_texture(out, scene, scene.materials[object.material]);
        if (object.transform) {
            const Affine& m = *object.transform;
            out << " matrix<";
            for (std::size_t column = 0; column < 4; ++column) {
                for (std::size_t row = 0; row < 3; ++row) {
                    out << m[row][column] << (column == 3 && row == 2 ? "" : ",");
                }
            }
            out << '>';
        }
        out << "}\n";
    }
    return out.str();
}

PovrayRun run_povray(const Scene& scene) {
    std::string name = (std::filesystem::temp_directory_path() / "raytree-povray-XXXXXX").string();
    if (!mkdtemp(name.data())) {
        throw std::runtime_error("no folder for POV-Ray in " + name);
    }
    const std::filesystem::path folder = name;
    PovrayRun result;
    try {
        write_output((folder / "scene.pov").string(), povray_text(scene));
        const int width = scene.camera.width, height = scene.camera.height;
        const double first = run_once(folder, width, height);
        result.picture = read_ppm16(read_input((folder / "picture.ppm").string()));
        const double larger = run_once(folder, 4 * width, 4 * height);
        result.seconds_a_pixel = std::max(0.0, larger - first) / (15.0 * width * height);
    } catch (...) {
        std::filesystem::remove_all(folder);
        throw;
    }
    std::filesystem::remove_all(folder);
    return result;
}

}  // namespace raytree::bench
