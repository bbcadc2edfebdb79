#include "formats/course_text.h"

#include <algorithm>
#include <array>
#include <unordered_map>
#include <utility>

#include "formats/did_you_mean.h"
#include "formats/json_text.h"
#include "formats/word_reader.h"
#include "scene/progress.h"
#include "scene/range_check.h"

namespace raytree {
namespace {

constexpr std::array<std::string_view, 11> kStatements{"NEAR",   "LEFT",   "RIGHT", "BOTTOM",
                                                       "TOP",    "RES",    "BACK",  "AMBIENT",
                                                       "OUTPUT", "SPHERE", "LIGHT"};

/// What the format leaves unsaid.
Settings course_settings() {
    Settings settings;
    settings.max_depth = 4;
    settings.min_weight = 0;
    settings.pixel_sample = PixelSample::corner;
    settings.secondary_background = Colour(0.0);
    settings.quantize = Quantize::floor;
    return settings;
}

class CourseReader {
  public:
    CourseReader(std::string_view text, std::string file)
        : words_(text, std::move(file), WordReader::Comments::none) {}

    CourseScene read();

  private:
    using FirstLines = std::unordered_map<std::string_view, std::size_t>;

    void statement(const Word& keyword);
    void single_statement(const Word& keyword);
    void once(FirstLines& lines, const Word& word, const std::string& what) const;
    std::string_view name(const Word& keyword, FirstLines& names);
    void sphere(const Word& keyword);
    void light(const Word& keyword);
    void output(const Word& keyword);
    double positive(std::string_view what);
    double coefficient(std::string_view what);
    void set_window();

    WordReader words_;
    CourseScene result_;
    double near_ = 1;
    ImagePlane window_;  // at the distance `near_`
    FirstLines statements_;
    FirstLines sphere_names_;
    FirstLines light_names_;
};

CourseScene CourseReader::read() {
    Scene& scene = result_.scene;
    scene.ambient = Colour(0.0);
    scene.settings = course_settings();
    ProgressCounter progress("reading");
    while (!words_.at_end()) {
        progress.at(words_.position(), words_.size());
        words_.stay_on_line(0);
        const Word keyword = words_.next();
        words_.stay_on_line(keyword.line);
        statement(keyword);
        if (words_.continues(keyword.line)) {
            const Word word = words_.peek();
            words_.fail(word, words_.found(word) + " where the statement " +
                                  std::string(keyword.text) + " ends");
        }
    }
    if (!statements_.contains("RES")) {
        throw InputError(words_.file(), "", "has no resolution; one statement RES x y is needed");
    }
    set_window();
    return std::move(result_);
}

void CourseReader::statement(const Word& keyword) {
    if (keyword.text == "SPHERE") {
        sphere(keyword);
    } else if (keyword.text == "LIGHT") {
        light(keyword);
    } else if (std::ranges::find(kStatements, keyword.text) != kStatements.end()) {
        once(statements_, keyword, "the statement " + std::string(keyword.text));
        single_statement(keyword);
    } else {
        words_.fail(keyword, words_.found(keyword) +
                                 ", must be a statement: NEAR, LEFT, RIGHT, BOTTOM, TOP, RES, "
                                 "SPHERE, LIGHT, BACK, AMBIENT or OUTPUT" +
                                 did_you_mean(keyword.text, kStatements));
    }
}

void CourseReader::single_statement(const Word& keyword) {
    Scene& scene = result_.scene;
    const std::string_view text = keyword.text;
    if (text == "NEAR") {
        near_ = positive("NEAR n");
    } else if (text == "LEFT") {
        window_.left = words_.number("LEFT l");
    } else if (text == "RIGHT") {
        window_.right = words_.number("RIGHT r");
    } else if (text == "BOTTOM") {
        window_.bottom = words_.number("BOTTOM b");
    } else if (text == "TOP") {
        window_.top = words_.number("TOP t");
    } else if (text == "RES") {
        scene.camera.width = static_cast<int>(words_.whole_number("RES x y", 1, kLargestSide));
        scene.camera.height = static_cast<int>(words_.whole_number("RES x y", 1, kLargestSide));
    } else if (text == "BACK") {
        scene.background = words_.colour("BACK r g b");
    } else if (text == "AMBIENT") {
        scene.ambient = words_.colour("AMBIENT Ir Ig Ib");
    } else {
        output(keyword);
    }
}

/// Refuses what is said a second time.
void CourseReader::once(FirstLines& lines, const Word& word, const std::string& what) const {
    const auto [first, is_new] = lines.emplace(word.text, word.line);
    if (!is_new) {
        words_.fail(word, what + " is there twice, first on line " + std::to_string(first->second));
    }
}

std::string_view CourseReader::name(const Word& keyword, FirstLines& names) {
    const Word word = words_.next();
    if (word.text.empty()) {
        words_.fail(word, std::string(keyword.text) + " needs a name");
    }
    once(names, word, "the " + std::string(keyword.text) + " " + json_string(word.text));
    return word.text;
}

double CourseReader::positive(std::string_view what) {
    const Word word = words_.peek();
    const double number = words_.number(what);
    if (!(number > 0)) {
        words_.fail(word, words_.found(word) + ", must be over 0: " + std::string(what));
    }
    return number;
}

double CourseReader::coefficient(std::string_view what) {
    const Word word = words_.peek();
    const double number = words_.number(what);
    if (number < 0) {
        words_.fail(word, words_.found(word) + ", must be 0 or more: " + std::string(what));
    }
    return number;
}

void CourseReader::sphere(const Word& keyword) {
    constexpr std::string_view what = "SPHERE name px py pz sx sy sz r g b Ka Kd Ks Kr n";
    Scene& scene = result_.scene;
    Object object;
    object.name = name(keyword, sphere_names_);
    const Point p = words_.point(what);
    const Word scale_word = words_.peek();
    const Point s = words_.point(what);
    if (s.x == 0 || s.y == 0 || s.z == 0) {
        words_.fail(scale_word, "the scale of a sphere must not be 0 along any axis");
    }
    object.transform = Affine{{{s.x, 0, 0, p.x}, {0, s.y, 0, p.y}, {0, 0, s.z, p.z}}};
    object.shape = Sphere{};
    object.material = scene.materials.size();
    Material material;
    material.name = object.name;
    material.in_place = true;
    material.color = words_.colour(what);
    material.ka = Colour(coefficient(what));
    material.kd = Colour(coefficient(what));
    material.ks = Colour(coefficient(what));
    material.kr = Colour(coefficient(what));
    material.shininess = coefficient(what);
    scene.materials.push_back(std::move(material));
    scene.objects.push_back(std::move(object));
}

void CourseReader::light(const Word& keyword) {
    constexpr std::string_view what = "LIGHT name px py pz Ir Ig Ib";
    Light light;
    light.name = name(keyword, light_names_);
    light.kind = PointLight{words_.point(what), {}};
    light.intensity = words_.colour(what);
    result_.scene.lights.push_back(std::move(light));
}

/// Its last part alone: a scene from somewhere else does not choose the folder.
void CourseReader::output(const Word& keyword) {
    const Word word = words_.next();
    const std::size_t slash = word.text.find_last_of("/\\");
    const std::string_view last =
        slash == std::string_view::npos ? word.text : word.text.substr(slash + 1);
    if (last.empty() || last == "." || last == "..") {
        words_.fail(word.text.empty() ? keyword : word, "OUTPUT needs the name of a file");
    }
    result_.output = std::string(last);
}

void CourseReader::set_window() {
    const auto check = [&](double low, double high, std::string_view low_name,
                           std::string_view high_name) {
        if (low < high) {
            return;
        }
        const auto given = statements_.contains(high_name) ? statements_.find(high_name)
                                                           : statements_.find(low_name);
        throw InputError(words_.file(), "line " + std::to_string(given->second),
                         std::string(low_name) + " must be less than " + std::string(high_name));
    };
    check(window_.left, window_.right, "LEFT", "RIGHT");
    check(window_.bottom, window_.top, "BOTTOM", "TOP");
    Camera& camera = result_.scene.camera;
    camera.near = near_;
    camera.window = ImagePlane{window_.left / near_, window_.right / near_, window_.bottom / near_,
                               window_.top / near_};
}

}  // namespace

CourseScene read_course_text(std::string_view text, const std::filesystem::path& file) {
    CourseScene result = CourseReader(text, file.string()).read();
    result.scene.name = file.stem().string();
    return result;
}

}  // namespace raytree
