#include "check/submission.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <mutex>

#include "formats/output_file.h"
#include "formats/tree_json.h"
#include "scene/input_error.h"
#include "tree/explain.h"

namespace raytree::check {
namespace {

constexpr int float_digits = 9;   // enough for every float
constexpr int fewest_digits = 4;  // fewer are not taken for an excuse
constexpr int usual_digits = 6;   // of printf and of C++ streams

Numbers of(const Vec3<double>& v) { return {3, {v.x, v.y, v.z}}; }
Numbers of(const Rgb<double>& c) { return {3, {c.r, c.g, c.b}}; }
Numbers of(double x) { return {1, {x, 0, 0}}; }

Numbers of_hit(const TreeHit<double>& hit, Field field) {
    switch (field) {
        case Field::t:
            return of(hit.t);
        case Field::point:
            return of(hit.point);
        case Field::normal:
            return of(hit.normal);
        case Field::cos_incident:
            return of(hit.cos_incident);
        case Field::eta:
            return hit.interface ? Numbers{2, {hit.interface->eta1, hit.interface->eta2, 0}}
                                 : Numbers{};
        case Field::sin2_transmitted:
            return hit.interface ? of(hit.interface->sin2_transmitted) : Numbers{};
        default:
            return {};
    }
}

Numbers of_shadow(const ShadowPart<double>& shadow, Field field) {
    if (field == Field::distance && shadow.distance) {
        return of(*shadow.distance);
    }
    return field == Field::transmittance ? of(shadow.transmittance) : Numbers{};
}

/// How many significant digits, and how many behind the point, spell the number.
struct Spelling {
    int significant = 0;
    int decimals = 0;
};
Spelling spelling_of(double x) {
    char text[40];
    const char* const end =
        std::to_chars(text, text + sizeof text, x, std::chars_format::scientific).ptr;
    const char* const e = std::find(static_cast<const char*>(text), end, 'e');
    const auto digits = static_cast<int>(std::count_if(
        static_cast<const char*>(text), e, [](char c) { return c >= '0' && c <= '9'; }));
    int exponent = 0;
    std::from_chars(e + (e != end && e[1] == '+' ? 2 : 1), end, exponent);
    return {digits, std::max(0, digits - 1 - exponent)};
}

/// What a number was in a file, where scaling it back has cost it its last digits.
double without_last_digits(double x) {
    char text[40];
    std::snprintf(text, sizeof text, "%.12g", x);
    return std::strtod(text, nullptr);
}

/// Large files are parsed one at a time, so that a folder of them fits into memory.
std::mutex& large_file() {
    static std::mutex mutex;
    return mutex;
}
constexpr std::size_t large = std::size_t{2} << 20;

void refuse_if_large(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::exists(file, error) || std::filesystem::is_directory(file, error)) {
        return;  // whoever reads it says so
    }
    if (!std::filesystem::is_regular_file(file, error)) {
        throw InputError(file.string(), "", "is not a file");
    }
    const auto bytes = std::filesystem::file_size(file, error);
    if (!error && bytes > largest_submission) {
        throw InputError(file.string(), "",
                         "is " + std::to_string(((bytes - 1) >> 20) + 1) +
                             " MB large; a submission may have " +
                             std::to_string(largest_submission >> 20) + " MB");
    }
}

}  // namespace

Given Submission::fields() const {
    Given all;
    for (const Given& one : given) {
        all |= one;
    }
    return all;
}

Numbers numbers_of(const RayTree<double>& tree, std::size_t place, Field field) {
    const TreeRay<double>& ray = tree.rays[place];
    switch (field) {
        case Field::origin:
            return of(ray.origin);
        case Field::direction:
            return of(ray.direction);
        case Field::weight:
            return of(ray.weight);
        case Field::ambient:
            return of(ray.ambient);
        case Field::diffuse:
            return of(ray.diffuse);
        case Field::specular:
            return of(ray.specular);
        case Field::attenuation:
            return of(ray.attenuation);
        case Field::intensity:
            return of(ray.intensity);
        default:
            return ray.hit      ? of_hit(*ray.hit, field)
                   : ray.shadow ? of_shadow(*ray.shadow, field)
                                : Numbers{};
    }
}

Precision precision_of(const Submission& submission) {
    int significant = 0;
    int decimals = 0;
    bool floats = true;
    for (std::size_t ray = 0; ray < submission.tree.rays.size() && ray < 1000; ++ray) {
        for (std::size_t k = 0; k < field_count; ++k) {
            const Field field = static_cast<Field>(k);
            // Where a direction was not a unit vector, it and what is measured along it are not as
            // the file has them.
            const double unit = submission.units[ray];
            const bool scaled = (field == Field::direction || field == Field::t) && unit != 1;
            if (!submission.given[ray][k]) {
                continue;
            }
            const Numbers numbers = numbers_of(submission.tree, ray, field);
            for (int n = 0; n < numbers.size; ++n) {
                double x = numbers.x[static_cast<std::size_t>(n)];
                if (scaled) {
                    x = without_last_digits(field == Field::t ? x / unit : x * unit);
                }
                const Spelling spelling = spelling_of(x);
                significant = std::max(significant, spelling.significant);
                decimals = std::max(decimals, spelling.decimals);
                floats = floats && (scaled || static_cast<double>(static_cast<float>(x)) == x);
            }
        }
    }
    // "%.6f" leaves small numbers few digits.
    const bool fixed = decimals >= fewest_digits && decimals < float_digits;
    const double absolute = fixed ? 0.5 * std::pow(10.0, -decimals) : 0;
    if (significant > float_digits && !floats) {
        Precision precision;
        precision.absolute = absolute;
        return precision;
    }
    if (significant >= float_digits - 1) {
        return {0x1p-24, absolute, "float", significant};
    }
    // A tree of round numbers only may have been computed in any arithmetic.
    const int digits = significant < fewest_digits ? usual_digits : significant;
    return {std::max(0x1p-24, 0.5 * std::pow(10.0, 1 - digits)), absolute, "rounded", digits};
}

Submission parse_submission(const std::string& text, const std::string& file) {
    std::unique_lock<std::mutex> alone;
    if (text.size() > large) {
        alone = std::unique_lock(large_file());
    }
    std::string with_numbers = text;
    Submission submission;
    submission.not_numbers = take_out_not_numbers(with_numbers);
    ReadTree read = read_tree_json(with_numbers, file);
    submission.file = file;
    submission.tree = std::move(read.tree);
    submission.given = std::move(read.given);
    submission.ids = std::move(read.ids);
    submission.units = std::move(read.units);
    submission.remarks = std::move(read.warnings);
    submission.contradictions = std::move(read.contradictions);
    submission.has_camera = read.has_camera;
    submission.has_settings = read.has_settings;
    submission.lights = read.lights;
    if (!submission.gives(0, Field::intensity) && !is_zero(submission.tree.intensity)) {
        // The tree's is its primary ray's.
        submission.tree.rays[0].intensity = submission.tree.intensity;
        submission.given[0].set(place_of(Field::intensity));
    }
    submission.children = children_of(submission.tree);
    submission.has_shadow_rays = std::ranges::any_of(
        submission.tree.rays, [](const auto& ray) { return ray.shadow.has_value(); });
    submission.precision = precision_of(submission);
    return submission;
}

std::string load_submission_text(const std::filesystem::path& file) {
    refuse_if_large(file);
    return read_input(file);
}

}  // namespace raytree::check
