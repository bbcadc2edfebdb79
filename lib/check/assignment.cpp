#include "check/assignment.h"

#include <cmath>

#include "formats/json_reader.h"
#include "formats/scene_json.h"

namespace raytree::check {
namespace {

constexpr double most_values = 1e6;  // of one range

struct Range {
    double from = 0, to = 0, step = 0.01;
};

bool is_choice(const Json& value) { return value.is_object() && value.contains("one_of"); }
bool is_range(const Json& value) { return value.is_object() && value.contains("from"); }

Range read_range(const Json& value, const JsonPlace& place, JsonReport& report) {
    const ObjectReader reader(value, place, report);
    Range range;
    const bool read = reader.number("from", range.from, Need::required) &
                      reader.number("to", range.to, Need::required);
    reader.number("step", range.step, Need::optional);
    reader.nothing_but({"from", "to", "step"});
    if (!read) {
        return {};
    }
    if (!(range.from <= range.to)) {
        report.add(place, "from must not be above to");
    } else if (!(range.step > 0) || (range.to - range.from) / range.step > most_values) {
        report.add(reader.place_of("step"), "must be above 0, and give a million values at most");
    } else {
        return range;
    }
    return {};
}

/// Looks at every range and choice without drawing.
void validate(const Json& value, const JsonPlace& place, JsonReport& report) {
    if (is_range(value)) {
        read_range(value, place, report);
    } else if (is_choice(value)) {
        const ObjectReader reader(value, place, report);
        reader.nothing_but({"one_of"});
        const Json& list = value.at("one_of");
        const JsonPlace at = reader.place_of("one_of");
        if (!list.is_array() || list.empty()) {
            report.add(at, "found " + shown(list) + ", must be a list of values to choose from");
            return;
        }
        for (std::size_t k = 0; k < list.size(); ++k) {
            validate(list[k], at.element(k), report);
        }
    } else if (value.is_object()) {
        for (const auto& [key, member] : value.get_ref<const Json::object_t&>()) {
            validate(member, place.member(key), report);
        }
    } else if (value.is_array()) {
        for (std::size_t k = 0; k < value.size(); ++k) {
            validate(value[k], place.element(k), report);
        }
    }
}

/// The number `count` steps above `from`, with the digits of the step alone.
double stepped(const Range& range, std::uint64_t count) {
    const double exact = range.from + static_cast<double>(count) * range.step;
    return std::round(exact * 1e9) / 1e9;
}

Json drawn(const Json& value, SplitMix64& random) {
    if (is_range(value)) {
        Range range{value.at("from").get<double>(), value.at("to").get<double>(), 0.01};
        range.step = value.value("step", range.step);
        const auto values =
            static_cast<std::uint64_t>(std::floor((range.to - range.from) / range.step + 1e-9) + 1);
        const double number = stepped(range, random.below(values));
        if (number == std::floor(number) && std::abs(number) < 1e15) {
            return static_cast<std::int64_t>(number);
        }
        return number;
    }
    if (is_choice(value)) {
        const Json& list = value.at("one_of");
        return drawn(list[random.below(list.size())], random);
    }
    if (!value.is_structured()) {
        return value;
    }
    Json out = value.is_object() ? Json::object() : Json::array();
    if (value.is_object()) {
        for (const auto& [key, member] : value.get_ref<const Json::object_t&>()) {
            out[key] = drawn(member, random);
        }
    } else {
        for (const Json& element : value) {
            out.push_back(drawn(element, random));
        }
    }
    return out;
}

/// What of a scene lets mistakes go unseen.
std::vector<std::string> what_hides(const Scene& scene) {
    std::vector<std::string> warnings;
    for (const Material& material : scene.materials) {
        const bool even = std::fmod(material.shininess, 2) == 0;
        if (!is_zero(material.ks) && even) {
            warnings.push_back("the shininess of " + material.name +
                               " is even: it hides signs in R . V");
        }
    }
    const auto* window = std::get_if<ImagePlane>(&scene.camera.window);
    if (!window || (window->left == -window->right && window->bottom == -window->top)) {
        warnings.emplace_back("the window is symmetric: it hides a left or bottom that is ignored");
    }
    if (scene.camera.width == scene.camera.height) {
        warnings.emplace_back("width and height are equal: they hide a wrong aspect");
    }
    return warnings;
}

}  // namespace

std::uint64_t SplitMix64::next() {
    std::uint64_t z = state_ += 0x9E3779B97F4A7C15U;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31U);
}

std::uint64_t SplitMix64::below(std::uint64_t n) { return (next() >> 32U) * n >> 32U; }

Assignment read_assignment(const std::string& text, const std::filesystem::path& file) {
    JsonReport report;
    report.file = file.string();
    Json document = parse_json(text, report.file);
    check_json_format(document, "raytree-assignment", 1, 0, report);
    const JsonPlace top;
    const ObjectReader reader(document, top, report);
    Assignment assignment;
    assignment.file = report.file;
    assignment.folder = file.parent_path();
    assignment.name = file.stem().string();
    reader.text("name", assignment.name, Need::optional);
    std::int64_t pixels = 3;
    reader.whole_number("pixels", pixels, Need::optional, 1, 100);
    assignment.pixels = static_cast<std::size_t>(pixels);
    if (const Json* const exposes = reader.find("exposes")) {
        const JsonPlace at = reader.place_of("exposes");
        for (const Json& id : exposes->is_array() ? *exposes : Json::array({nullptr})) {
            if (id.is_string()) {
                assignment.exposes.push_back(id.get<std::string>());
            } else {
                report.add(at, "must be a list of beginnings of mistakes' names, such as \"shd.\"");
            }
        }
    }
    reader.nothing_but({"format", "name", "pixels", "exposes", "scene"});
    const Json* const scene = reader.need("scene", "a scene with ranges");
    const JsonPlace at = reader.place_of("scene");
    if (scene && ObjectReader::is_object(*scene, at, report)) {
        validate(*scene, at, report);
        assignment.scene = *scene;
    }
    if (!report.mistakes.empty()) {
        throw InputError(std::move(report.mistakes));
    }
    variant_of(assignment, 0, 1);  // says at once what is no scene whatever is drawn
    return assignment;
}

Variant variant_of(const Assignment& assignment, std::uint64_t seed, std::size_t number) {
    SplitMix64 random(seed * 0x9E3779B97F4A7C15U + number);
    random.next();
    const Json document = drawn(assignment.scene, random);
    JsonReport report;
    report.file = assignment.file;
    Variant variant;
    try {
        variant.scene = read_scene_json(document, assignment.folder, report);
    } catch (const InputError& error) {
        report.mistakes = error.mistakes();
    }
    if (!report.mistakes.empty()) {
        for (Mistake& mistake : report.mistakes) {
            mistake.place = "/scene" + mistake.place;
            mistake.text += " (as drawn for variant " + std::to_string(number) + ")";
        }
        throw InputError(std::move(report.mistakes));
    }
    if (variant.scene.name.empty()) {
        variant.scene.name = assignment.name;
    }
    variant.warnings = what_hides(variant.scene);
    return variant;
}

}  // namespace raytree::check
