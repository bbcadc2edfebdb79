#include "formats/measure_map.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "tree/explain.h"

namespace raytree {
namespace {

/// What each measure says of a pixel, and in which unit; in the order of Measure.
struct Meaning {
    std::string_view word;
    std::string_view text;
    double unit;  ///< of a value, in those of Measurement
    const char* unit_name;
};
constexpr std::array<Meaning, 5> meanings = {{
    {"rays", "rays in the pixel's tree, shadow rays too", 1, ""},
    {"levels", "levels of the pixel's tree", 1, ""},
    {"tests", "tests of a ray with a shape", 1, ""},
    {"time", "time that the pixel took", 1000, " µs"},
    {"ended", "why the tree's weightiest branch ended", 1, ""},
}};

const Meaning& meaning_of(Measure measure) { return meanings[static_cast<std::size_t>(measure)]; }

}  // namespace

std::string_view word_of(Measure measure) { return meaning_of(measure).word; }
std::string_view text_of(Measure measure) { return meaning_of(measure).text; }

std::string measured_text(double value, Measure measure) {
    const Meaning& meaning = meaning_of(measure);
    const double amount = value / meaning.unit;
    if (measure != Measure::nanoseconds || amount >= 1e6) {
        return number_text(amount) + meaning.unit_name;
    }
    // As exact as a clock is: times that stand beside each other have alike digits.
    const int decimals = amount < 10 ? 2 : amount < 100 ? 1 : 0;
    std::array<char, 32> digits;
    char* const end =
        std::to_chars(digits.begin(), digits.end(), amount, std::chars_format::fixed, decimals).ptr;
    return std::string(digits.data(), end) + meaning.unit_name;
}

MapRange map_range(const std::vector<double>& values, Measure measure) {
    const auto [least, most] = std::ranges::minmax(values);
    if (measure != Measure::nanoseconds) {
        return {least, most, most};
    }
    std::vector<double> sorted = values;
    const auto last = sorted.begin() + static_cast<std::ptrdiff_t>((sorted.size() - 1) * 99 / 100);
    std::ranges::nth_element(sorted, last);
    return {least, *last, most};
}

Colour8 map_colour(double value, Measure measure, const MapRange& range) {
    if (measure == Measure::ended) {
        return reason_colour(static_cast<Reason>(value));
    }
    const double extent = range.most - range.least;
    return scale_colour(extent > 0 ? (value - range.least) / extent : 0);
}

ErrorRange error_range(const std::vector<double>& errors) {
    ErrorRange range;
    for (const double error : errors) {
        range.exact += error == 0 ? 1 : 0;
        range.most = std::max(range.most, error);
        if (error > 0 && (range.least == 0 || error < range.least)) {
            range.least = error;
        }
    }
    return range;
}

Colour8 error_colour(double error, const ErrorRange& range) {
    if (error == 0) {
        return {0, 0, 0};
    }
    const double extent = std::log(range.most / range.least);
    return scale_colour(extent > 0 ? std::log(error / range.least) / extent : 0);
}

std::vector<ReasonPixels> reasons_in(const std::vector<double>& map) {
    std::array<std::size_t, reason_count> pixels{};
    for (const double reason : map) {
        ++pixels[static_cast<std::size_t>(reason)];
    }
    std::vector<ReasonPixels> present;
    for (std::size_t k = 0; k < pixels.size(); ++k) {
        if (pixels[k] > 0) {
            present.push_back({static_cast<Reason>(k), pixels[k]});
        }
    }
    std::ranges::stable_sort(present, std::greater{}, &ReasonPixels::pixels);
    return present;
}

}  // namespace raytree
