#include "formats/nff.h"

#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "formats/scene_words.h"
#include "formats/split_polygon.h"
#include "formats/word_reader.h"
#include "scene/planarity.h"
#include "scene/progress.h"
#include "scene/range_check.h"

namespace raytree {
namespace {

constexpr int kImpliedDepth = 5;
/// Splitting takes time with the square of the number of vertices or more.
constexpr std::size_t kMostSplit = 1000;

class NffReader {
  public:
    NffReader(std::string_view text, std::string file, std::optional<std::pair<int, int>> size,
              std::vector<std::string>& warnings)
        : words_(text, std::move(file), WordReader::Comments::hash),
          size_(size),
          warnings_(warnings) {}

    Scene read();

  private:
    void statement(const Word& word);
    void view(const Word& word);
    void view_parameter(const Word& name, double& angle, double& hither);
    void set_window(const Word& word, double angle);
    void light();
    void material(const Word& word);
    void sphere();
    void cone(const Word& word);
    void polygon(const Word& word, bool with_normals);
    void add_split(const Polygon& polygon, const Word& word);
    void add(Shape shape);
    double radius(std::string_view what);

    WordReader words_;
    std::optional<std::pair<int, int>> size_;
    std::vector<std::string>& warnings_;
    Scene scene_;
    bool has_view_ = false;
    std::vector<std::size_t> colourless_;  // lights
};

Scene NffReader::read() {
    scene_.ambient = Colour(0.0);
    scene_.settings.max_depth = kImpliedDepth;
    scene_.settings.min_weight = 0;
    ProgressCounter progress("reading");
    while (!words_.at_end()) {
        progress.at(words_.position(), words_.size());
        statement(words_.next());
    }
    if (!has_view_) {
        throw InputError(words_.file(), "", "has no view; one statement v is needed");
    }
    for (const std::size_t light : colourless_) {
        const auto count = static_cast<double>(scene_.lights.size());
        scene_.lights[light].intensity = Colour(1 / std::sqrt(count));
    }
    return std::move(scene_);
}

void NffReader::statement(const Word& word) {
    const bool is_shape =
        word.text == "s" || word.text == "c" || word.text == "p" || word.text == "pp";
    if (is_shape && scene_.materials.empty()) {
        words_.fail(word, "a shape needs a material before it: a statement f");
    }
    if (word.text == "v") {
        view(word);
    } else if (word.text == "b") {
        scene_.background = words_.colour("the background, b r g b");
    } else if (word.text == "l") {
        light();
    } else if (word.text == "f") {
        material(word);
    } else if (word.text == "s") {
        sphere();
    } else if (word.text == "c") {
        cone(word);
    } else if (word.text == "p" || word.text == "pp") {
        polygon(word, word.text == "pp");
    } else {
        words_.fail(word, words_.found(word) + ", must be a statement: v, b, l, f, s, c, p or pp");
    }
}

void NffReader::view(const Word& word) {
    if (has_view_) {
        words_.fail(word, "a second view v; one is allowed");
    }
    has_view_ = true;
    constexpr std::array<std::string_view, 6> names{"from",  "at",     "up",
                                                    "angle", "hither", "resolution"};
    std::array<bool, names.size()> given{};
    double angle = 0;
    Word angle_word;
    for (;;) {
        const Word name = words_.peek();
        std::size_t k = 0;
        while (k < names.size() && names[k] != name.text) {
            ++k;
        }
        if (k == names.size()) {
            break;
        }
        if (std::exchange(given[k], true)) {
            words_.fail(name, "a second \"" + std::string(name.text) + "\" in the view v");
        }
        if (name.text == "angle") {
            angle_word = name;
        }
        view_parameter(words_.next(), angle, scene_.camera.near);
    }
    for (std::size_t k = 0; k < names.size(); ++k) {
        if (!given[k] && names[k] != "hither") {
            const Word next = words_.peek();
            const std::string end =
                next.text.empty() ? "" : ", which ends at \"" + std::string(next.text) + "\"";
            words_.fail(next, "\"" + std::string(names[k]) + "\" is missing in the view v" + end);
        }
    }
    set_window(angle_word, angle);
}

void NffReader::view_parameter(const Word& name, double& angle, double& hither) {
    Camera& camera = scene_.camera;
    if (name.text == "from") {
        camera.eye = words_.point("from x y z");
    } else if (name.text == "at") {
        camera.look_at = words_.point("at x y z");
    } else if (name.text == "up") {
        camera.up = words_.point("up x y z");
    } else if (name.text == "angle") {
        angle = words_.number("angle, in degrees");
    } else if (name.text == "hither") {
        const Word word = words_.peek();
        hither = words_.number("hither");
        if (hither < 0) {
            words_.fail(word, "hither must be 0 or more");
        }
    } else {
        const auto side = [&] {
            return static_cast<int>(words_.whole_number("resolution x y", 1, kLargestSide));
        };
        camera.width = side();
        camera.height = side();
    }
}

/// The angle is between the centres of the first and the last pixel row.
void NffReader::set_window(const Word& word, double angle) {
    Camera& camera = scene_.camera;
    if (size_) {
        std::tie(camera.width, camera.height) = *size_;
    }
    if (!(angle > 0 && angle < 180)) {
        words_.fail(word, "the angle must be over 0 and under 180 degrees");
    }
    if (camera.height == 1) {
        words_.fail(word,
                    "a picture of one row has no angle between its rows; the height must be "
                    "2 or more");
    }
    const double width = camera.width;
    const double height = camera.height;
    const double half_height =
        std::tan(angle / 2 * (Real<double>::pi / 180)) * height / (height - 1);
    const double half_width = half_height * width / height;
    camera.window = ImagePlane{-half_width, half_width, -half_height, half_height};
}

void NffReader::light() {
    Light light;
    light.name = "light" + std::to_string(scene_.lights.size());
    light.kind = PointLight{words_.point("a light, l x y z [r g b]"), {}};
    if (words_.number_follows()) {
        light.intensity = words_.colour("a light's colour, l x y z r g b");
    } else {
        colourless_.push_back(scene_.lights.size());
    }
    scene_.lights.push_back(std::move(light));
}

void NffReader::material(const Word& word) {
    constexpr std::string_view what = "a material, f r g b Kd Ks Shine T ior";
    const auto coefficient = [&] {
        const Word at = words_.peek();
        const double number = words_.number(what);
        if (number < 0) {
            words_.fail(at, "Kd, Ks, Shine, T and ior must be 0 or more");
        }
        return number;
    };
    Material material;
    material.name = "material" + std::to_string(scene_.materials.size());
    material.color = words_.colour(what);
    material.ka = Colour(0.0);
    material.kd = Colour(coefficient());
    material.ks = material.kr = Colour(coefficient());
    material.shininess = coefficient();
    material.kt = Colour(coefficient());
    material.ior = coefficient();
    if (material.ior == 0) {
        if (!is_zero(material.kt)) {
            words_.fail(word, "ior is 0 in a material that transmits light; it must be over 0");
        }
        material.ior = 1;
    }
    scene_.materials.push_back(std::move(material));
}

double NffReader::radius(std::string_view what) { return std::abs(words_.number(what)); }

void NffReader::sphere() {
    constexpr std::string_view what = "a sphere, s x y z r";
    Sphere sphere;
    sphere.center = words_.point(what);
    const Word word = words_.peek();
    sphere.radius = radius(what);
    if (sphere.radius == 0) {
        words_.fail(word, "a sphere's radius must not be 0");
    }
    add(sphere);
}

void NffReader::cone(const Word& word) {
    constexpr std::string_view what = "a cone, c x y z r0 x y z r1";
    Cone cone;
    cone.base = words_.point(what);
    cone.base_radius = radius(what);
    cone.apex = words_.point(what);
    cone.apex_radius = radius(what);
    if (cone.base_radius == 0 && cone.apex_radius == 0) {
        words_.fail(word, "a cone's radii are both 0; one of them must not be");
    }
    if (cone.base == cone.apex) {
        words_.fail(word, "a cone's base and apex are the same point; they must differ");
    }
    add(cone);
}

void NffReader::polygon(const Word& word, bool with_normals) {
    const long long count = words_.whole_number("the number of vertices of a polygon", 3,
                                                std::numeric_limits<int>::max());
    Polygon polygon;
    for (long long k = 0; k < count; ++k) {
        polygon.vertices.push_back(words_.point("a vertex, x y z"));
        if (!with_normals) {
            continue;
        }
        const Word at = words_.peek();
        polygon.normals.push_back(words_.point("a vertex normal, nx ny nz"));
        if (polygon.normals.back() == Point(0)) {
            words_.fail(at, "a vertex normal must have a length");
        }
    }
    const Planarity planarity = planarity_of(polygon.vertices);
    if (!planarity.has_area()) {
        words_.fail(word,
                    "the vertices of a polygon lie on one line, or it has no area; they must "
                    "span a plane");
    }
    if (planarity.is_planar()) {
        add(std::move(polygon));
    } else {
        add_split(polygon, word);
    }
}

void NffReader::add_split(const Polygon& polygon, const Word& word) {
    if (polygon.vertices.size() > kMostSplit) {
        words_.fail(word, "the polygon of " + std::to_string(polygon.vertices.size()) +
                              " vertices is not planar; at most " + std::to_string(kMostSplit) +
                              " can be split into triangles");
    }
    std::vector<Polygon> triangles = split_into_triangles(polygon);
    const std::string text = "the polygon of " + std::to_string(polygon.vertices.size()) +
                             " vertices is not planar; it is split into " +
                             std::to_string(triangles.size()) + " triangles";
    warnings_.push_back(Mistake{words_.file(), words_.place(word), text}.message());
    for (Polygon& triangle : triangles) {
        add(std::move(triangle));
    }
}

void NffReader::add(Shape shape) {
    Object object;
    object.name = std::string(type_word(shape)) + std::to_string(scene_.objects.size());
    object.material = scene_.materials.size() - 1;
    object.shape = std::move(shape);
    scene_.objects.push_back(std::move(object));
}

}  // namespace

Scene read_nff(std::string_view text, const std::filesystem::path& file,
               std::optional<std::pair<int, int>> size, std::vector<std::string>& warnings) {
    Scene scene = NffReader(text, file.string(), size, warnings).read();
    scene.name = file.stem().string();
    return scene;
}

}  // namespace raytree
