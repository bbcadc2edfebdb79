#include "scene/validate.h"

#include <array>
#include <charconv>
#include <string_view>
#include <unordered_map>

#include "scene/planarity.h"

namespace raytree {
namespace {

/// Enough to see what is wrong with a file; a generated one may hold a million mistakes.
constexpr std::size_t kMostMistakes = 50;
constexpr int kLargestSide = 65535;
constexpr long long kMostPixels = 1LL << 28;
constexpr int kDeepest = 64;
/// The sine below which two directions count as parallel.
constexpr double kParallel = 1e-12;
/// A determinant of rows (or columns) of length 1 below this is what rounding leaves of 0.
constexpr double kSingular = 16 * std::numeric_limits<double>::epsilon();

std::string shown(double number) {
    std::array<char, 32> buffer;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number);
    return {buffer.data(), end.ptr};
}

std::string quoted(const std::string& name) { return "\"" + name + "\""; }

/// A part of a JSON pointer (RFC 6901).
std::string pointer_part(std::string_view key) {
    std::string part = "/";
    for (const char c : key) {
        part += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
    }
    return part;
}

bool is_finite(const Point& p) { return isfinite(p.x) && isfinite(p.y) && isfinite(p.z); }

/// Goes through a scene and notes what is wrong. `at` is the pointer of what is being looked at;
/// pointers of its members are put together only where there is a mistake.
class Validator {
  public:
    explicit Validator(const Scene& scene) : scene_(scene) {}

    std::vector<Mistake> run() {
        camera();
        settings();
        colour("", "/background", scene_.background);
        colour("", "/ambient", scene_.ambient);
        materials();
        lights();
        objects();
        if (left_out_ > 0) {
            mistakes_.push_back({"", "", "and " + std::to_string(left_out_) + " more mistakes"});
        }
        return std::move(mistakes_);
    }

  private:
    void add(std::string place, std::string text) {
        if (mistakes_.size() < kMostMistakes) {
            mistakes_.push_back({"", std::move(place), std::move(text)});
        } else {
            ++left_out_;
        }
    }
    bool require(bool good, const std::string& at, const char* member, double found,
                 const char* allowed) {
        if (!good) {
            add(at + member, "found " + shown(found) + ", must be " + allowed);
        }
        return good;
    }
    bool not_negative(const std::string& at, const char* member, double found) {
        return require(found >= 0 && isfinite(found), at, member, found,
                       "a finite number, 0 or more");
    }
    bool positive(const std::string& at, const char* member, double found) {
        return require(found > 0 && isfinite(found), at, member, found, "a finite number over 0");
    }
    bool point(const std::string& at, const std::string& member, const Point& p) {
        if (!is_finite(p)) {
            add(at + member, "must be three finite numbers");
        }
        return is_finite(p);
    }
    void colour(const std::string& at, const char* member, const Colour& c) {
        if (!isfinite(c)) {
            add(at + member, "must be finite numbers");
        }
    }
    void coefficient(const std::string& at, const char* member, const Colour& c) {
        for (const double channel : {c.r, c.g, c.b}) {
            if (!not_negative(at, member, channel)) {
                return;
            }
        }
    }

    void camera();
    void window(const Camera& camera);
    void settings();
    void attenuation(const std::string& at, const Attenuation& attenuation);
    void materials();
    void lights();
    void objects();
    void transform(const std::string& at, const Affine& transform);
    void shape(const std::string& at, const Sphere& sphere);
    void shape(const std::string& at, const Polygon& polygon);
    void shape(const std::string& at, const Cone& cone);
    void shape(const std::string& at, const Mesh& mesh);
    template <class Named> void unique_names(const char* list, const std::vector<Named>& named);

    const Scene& scene_;
    std::vector<Mistake> mistakes_;
    std::size_t left_out_ = 0;
};

void Validator::camera() {
    const Camera& camera = scene_.camera;
    const std::string at = "/camera";
    window(camera);
    not_negative(at, "/near", camera.near);
    const bool finite = point(at, "/eye", camera.eye) & point(at, "/look_at", camera.look_at) &
                        point(at, "/up", camera.up);
    if (!finite) {
        return;
    }
    const Point view = camera.look_at - camera.eye;
    if (camera.eye == camera.look_at) {
        add(at, "eye and look_at are the same point; they must differ");
    } else if (!is_finite(view)) {
        add(at, "eye and look_at are too far apart; their difference must be finite");
    } else if (camera.up == Point(0)) {
        add(at + "/up", "found a vector of length 0, must have a length");
    } else if (length(outer(UnitVec3<double>::of(view).vec(),
                            UnitVec3<double>::of(camera.up).vec())) < kParallel) {
        add(at, "up is parallel to the view from eye to look_at; it must not be");
    }
}

void Validator::window(const Camera& camera) {
    const std::string at = "/camera";
    constexpr const char* side = "a whole number from 1 to 65535";
    const auto is_side = [](int n) { return n >= 1 && n <= kLargestSide; };
    const bool sides = require(is_side(camera.width), at, "/width", camera.width, side) &
                       require(is_side(camera.height), at, "/height", camera.height, side);
    const long long pixels = static_cast<long long>(camera.width) * camera.height;
    if (sides && pixels > kMostPixels) {
        add(at, "width times height is " + std::to_string(pixels) +
                    " pixels; at most 2^28 = " + std::to_string(kMostPixels) + " are allowed");
    }
    if (const auto* fov = std::get_if<HorizontalFov>(&camera.window)) {
        require(fov->degrees > 0 && fov->degrees < 180, at, "/horizontal_fov_degrees", fov->degrees,
                "over 0 and under 180");
        return;
    }
    const auto& plane = std::get<ImagePlane>(camera.window);
    const double width = plane.right - plane.left;
    const double height = plane.top - plane.bottom;
    if (!(width > 0 && height > 0 && isfinite(width) && isfinite(height))) {
        add(at + "/image_plane", "found [" + shown(plane.left) + ", " + shown(plane.right) + ", " +
                                     shown(plane.bottom) + ", " + shown(plane.top) +
                                     "], must be finite numbers [left, right, bottom, top] with "
                                     "left < right and bottom < top");
    }
}

void Validator::settings() {
    const Settings& settings = scene_.settings;
    const std::string at = "/settings";
    require(settings.max_depth >= 1 && settings.max_depth <= kDeepest, at, "/max_depth",
            settings.max_depth, "a whole number from 1 to 64");
    not_negative(at, "/min_weight", settings.min_weight);
    if (settings.max_distance) {
        positive(at, "/max_distance", *settings.max_distance);
    }
    attenuation(at, settings.attenuation);
    if (settings.secondary_background) {
        colour(at, "/secondary_background", *settings.secondary_background);
    }
    require(settings.ray_budget >= 1, at, "/ray_budget", 0, "a whole number from 1");
}

void Validator::attenuation(const std::string& at, const Attenuation& f) {
    const auto good = [](double x) { return x >= 0 && isfinite(x); };
    if (!good(f.a) || !good(f.b) || !good(f.c) || f == Attenuation{0, 0, 0}) {
        add(at + "/attenuation", "found [" + shown(f.a) + ", " + shown(f.b) + ", " + shown(f.c) +
                                     "], must be three finite numbers, each 0 or more, not all 0");
    }
}

void Validator::materials() {
    std::vector<std::size_t> owner(scene_.materials.size(), scene_.objects.size());
    for (std::size_t k = 0; k < scene_.objects.size(); ++k) {
        if (scene_.objects[k].material < owner.size()) {
            owner[scene_.objects[k].material] = k;
        }
    }
    std::unordered_map<std::string_view, std::size_t> names;
    for (std::size_t k = 0; k < scene_.materials.size(); ++k) {
        const Material& material = scene_.materials[k];
        const std::string at = material.in_place
                                   ? "/objects/" + std::to_string(owner[k]) + "/material"
                                   : "/materials" + pointer_part(material.name);
        if (!material.in_place && !names.emplace(material.name, k).second) {
            add(at, "the name " + quoted(material.name) + " is given to two materials");
        }
        colour(at, "/color", material.color);
        colour(at, "/specular_color", material.specular_color);
        coefficient(at, "/ka", material.ka);
        coefficient(at, "/kd", material.kd);
        coefficient(at, "/ks", material.ks);
        coefficient(at, "/kr", material.kr);
        coefficient(at, "/kt", material.kt);
        not_negative(at, "/shininess", material.shininess);
        positive(at, "/ior", material.ior);
    }
}

void Validator::lights() {
    unique_names("/lights/", scene_.lights);
    for (std::size_t k = 0; k < scene_.lights.size(); ++k) {
        const Light& light = scene_.lights[k];
        const std::string at = "/lights/" + std::to_string(k);
        colour(at, "/intensity", light.intensity);
        if (const auto* lamp = std::get_if<PointLight>(&light.kind)) {
            point(at, "/position", lamp->position);
            attenuation(at, lamp->attenuation);
        } else {
            const Point& direction = std::get<DirectionalLight>(light.kind).direction;
            if (point(at, "/direction", direction) && direction == Point(0)) {
                add(at + "/direction", "found a vector of length 0, must have a length");
            }
        }
    }
}

void Validator::objects() {
    unique_names("/objects/", scene_.objects);
    for (std::size_t k = 0; k < scene_.objects.size(); ++k) {
        const Object& object = scene_.objects[k];
        const std::string at = "/objects/" + std::to_string(k);
        if (object.material >= scene_.materials.size()) {
            add(at + "/material", "is missing; an object needs a material");
        }
        if (object.transform) {
            transform(at + "/transform", *object.transform);
        }
        std::visit([&](const auto& s) { shape(at, s); }, object.shape);
    }
}

template <class Named>
void Validator::unique_names(const char* list, const std::vector<Named>& named) {
    std::unordered_map<std::string_view, std::size_t> first;
    for (std::size_t k = 0; k < named.size(); ++k) {
        const auto [place, is_new] = first.emplace(named[k].name, k);
        if (!is_new) {
            add(list + std::to_string(k) + "/name", "the name " + quoted(named[k].name) +
                                                        " is that of " + list +
                                                        std::to_string(place->second) +
                                                        " already, given or by default; each needs "
                                                        "a name of its own");
        }
    }
}

/// The determinant of a 3 x 3 matrix after each of its rows is scaled to length 1; 0 where it has a
/// row of length 0 or one that is not finite.
double scaled_determinant(const std::array<Point, 3>& rows) {
    std::array<Point, 3> unit;
    for (std::size_t k = 0; k < 3; ++k) {
        const double largest = largest_component(rows[k]);
        // The inverse has the reciprocals of the lengths, which are to be finite as well.
        if (!(largest > 0) || !isfinite(largest) || !isfinite(1 / largest)) {
            return 0;
        }
        unit[k] = UnitVec3<double>::of(rows[k]).vec();
    }
    return inner(unit[0], outer(unit[1], unit[2]));
}

void Validator::transform(const std::string& at, const Affine& m) {
    for (const auto& row : m) {
        for (const double number : row) {
            if (!isfinite(number)) {
                add(at, "must be finite numbers");
                return;
            }
        }
    }
    std::array<Point, 3> rows;
    std::array<Point, 3> columns;
    for (std::size_t k = 0; k < 3; ++k) {
        rows[k] = {m[k][0], m[k][1], m[k][2]};
        columns[k] = {m[0][k], m[1][k], m[2][k]};
    }
    // A matrix is as good as the better of its two scalings: both leave it as invertible as it is.
    const double determinant =
        max_of(abs(scaled_determinant(rows)), abs(scaled_determinant(columns)));
    if (!(determinant > kSingular)) {
        add(at, "is singular: it flattens the object; it must be invertible");
    }
}

void Validator::shape(const std::string& at, const Sphere& sphere) {
    point(at, "/center", sphere.center);
    positive(at, "/radius", sphere.radius);
}

void Validator::shape(const std::string& at, const Cone& cone) {
    const bool finite = point(at, "/base", cone.base) & point(at, "/apex", cone.apex);
    const bool radii = not_negative(at, "/base_radius", cone.base_radius) &
                       not_negative(at, "/apex_radius", cone.apex_radius);
    if (radii && cone.base_radius == 0 && cone.apex_radius == 0) {
        add(at, "base_radius and apex_radius are both 0; one of them must be over 0");
    }
    if (finite && cone.base == cone.apex) {
        add(at, "base and apex are the same point; they must differ");
    }
}

void Validator::shape(const std::string& at, const Polygon& polygon) {
    bool finite = true;
    for (std::size_t k = 0; k < polygon.vertices.size(); ++k) {
        finite &= point(at, "/vertices/" + std::to_string(k), polygon.vertices[k]);
    }
    if (polygon.vertices.size() < 3) {
        add(at + "/vertices",
            "found " + std::to_string(polygon.vertices.size()) + " vertices, must be 3 or more");
    } else if (finite) {
        const Planarity planarity = planarity_of(polygon.vertices);
        if (!planarity.has_area()) {
            add(at + "/vertices",
                "the vertices lie on one line, or the polygon has no area; "
                "they must span a plane");
        } else if (!planarity.is_planar()) {
            add(at + "/vertices", "the vertices are not planar: one is off their plane by " +
                                      shown(planarity.off_plane) +
                                      " of the polygon's extent, must be at most 1e-06");
        }
    }
    if (!polygon.normals.empty() && polygon.normals.size() != polygon.vertices.size()) {
        add(at + "/normals", "found " + std::to_string(polygon.normals.size()) + " normals for " +
                                 std::to_string(polygon.vertices.size()) +
                                 " vertices, must be one for each vertex");
    }
    for (std::size_t k = 0; k < polygon.normals.size(); ++k) {
        const std::string member = "/normals/" + std::to_string(k);
        if (point(at, member, polygon.normals[k]) && polygon.normals[k] == Point(0)) {
            add(at + member, "found a vector of length 0, must have a length");
        }
    }
}

/// A mesh has no pointers to its parts: those are in a file of their own, whose reader names lines.
void Validator::shape(const std::string& at, const Mesh& mesh) {
    const auto in_range = [](int index, int least, std::size_t count) {
        return index >= least && (index < 0 || static_cast<std::size_t>(index) < count);
    };
    if (mesh.triangles.empty()) {
        add(at + "/file", "the mesh has no triangle, must have at least one");
    }
    for (const Point& vertex : mesh.vertices) {
        if (!is_finite(vertex)) {
            add(at + "/file", "a vertex of the mesh is not finite");
            return;
        }
    }
    for (const Point& normal : mesh.normals) {
        if (!is_finite(normal)) {
            add(at + "/file", "a vertex normal of the mesh is not finite");
            return;
        }
    }
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
        for (const Mesh::Corner& corner : mesh.triangles[k]) {
            if (!in_range(corner.vertex, 0, mesh.vertices.size()) ||
                !in_range(corner.normal, -1, mesh.normals.size())) {
                add(at + "/file",
                    "triangle " + std::to_string(k) +
                        " of the mesh refers to a vertex or normal that is not there");
                return;
            }
        }
    }
}

}  // namespace

std::vector<Mistake> validate(const Scene& scene) { return Validator(scene).run(); }

}  // namespace raytree
