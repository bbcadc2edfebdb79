#include "map_picture.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "formats/colour_map.h"
#include "tree/explain.h"
#include "values.h"

namespace raytree::cli {
namespace {

/// What each measure says of a pixel, and in which unit; in the order of Measure.
struct Meaning {
    std::string_view word;
    const char* text;
    double unit;  ///< of a value, in those of Measurement
    const char* unit_name;
};
constexpr std::array<Meaning, 5> meanings = {{
    {"rays", "rays in the pixel's tree, shadow rays too", 1, ""},
    {"levels", "levels of the pixel's tree", 1, ""},
    {"tests", "tests of a ray with a shape", 1, ""},
    {"time", "time that the pixel took", 1000, " µs"},
    {"ended", "why the weightiest branch of the pixel's tree ended", 1, ""},
}};

const Meaning& meaning_of(Measure measure) { return meanings[static_cast<std::size_t>(measure)]; }

std::string shown(double value, Measure measure) {
    const Meaning& meaning = meaning_of(measure);
    return number_text(value / meaning.unit) + meaning.unit_name;
}

/// The values that get the first and the last colour. A few pixels during which the machine was
/// busy elsewhere would leave all others dark, so a map of time ends at the slowest hundredth.
struct Range {
    double least = 0;
    double most = 0;
    double beyond = 0;  ///< the largest there is
};

Range range_of(const std::vector<double>& values, Measure measure) {
    const auto [least, most] = std::ranges::minmax(values);
    if (measure != Measure::nanoseconds) {
        return {least, most, most};
    }
    std::vector<double> sorted = values;
    const auto last = sorted.begin() + static_cast<std::ptrdiff_t>((sorted.size() - 1) * 99 / 100);
    std::ranges::nth_element(sorted, last);
    return {least, *last, most};
}

std::string range_text(const Range& range, Measure measure) {
    return range.least == range.beyond
               ? "all " + shown(range.least, measure)
               : "from " + shown(range.least, measure) + " to " + shown(range.beyond, measure);
}

MapPicture scale_picture(const Measurement& measured, Measure measure) {
    const Range range = range_of(measured.map, measure);
    const double extent = range.most - range.least;
    MapPicture result{Image(measured.picture.width, measured.picture.height),
                      map_values(measured, measure)};
    for (std::size_t k = 0; k < measured.map.size(); ++k) {
        const double share = extent > 0 ? (measured.map[k] - range.least) / extent : 0;
        const Colour8 c = scale_colour(share);
        result.image.set(k, c[0], c[1], c[2]);
    }
    std::string colours = "dark violet is " + shown(range.least, measure);
    if (extent > 0) {
        colours += ", green in between, yellow " + shown(range.most, measure);
    }
    if (range.beyond > range.most) {
        colours += " and more: the slowest 1 % of the pixels are clamped";
    }
    result.legend.push_back(colours);
    return result;
}

std::array<std::size_t, reason_count> pixels_by_reason(const Measurement& measured) {
    std::array<std::size_t, reason_count> pixels{};
    for (const double reason : measured.map) {
        ++pixels[static_cast<std::size_t>(reason)];
    }
    return pixels;
}

/// One line for each reason that a pixel has, the most frequent first.
std::vector<std::string> reason_lines(const Measurement& measured, bool as_colours) {
    const auto pixels = pixels_by_reason(measured);
    std::vector<ReasonText> present;
    for (const ReasonText& text : reason_texts()) {
        if (pixels[static_cast<std::size_t>(text.reason)] > 0) {
            present.push_back(text);
        }
    }
    std::ranges::stable_sort(present, std::greater{}, [&](const ReasonText& text) {
        return pixels[static_cast<std::size_t>(text.reason)];
    });
    std::vector<std::string> lines;
    for (const ReasonText& text : present) {
        const auto number = static_cast<std::size_t>(text.reason);
        const Colour8 c = reason_colour(text.reason);
        std::array<char, 16> sign;
        if (as_colours) {
            std::snprintf(sign.data(), sign.size(), "#%02X%02X%02X", c[0], c[1], c[2]);
        } else {
            std::snprintf(sign.data(), sign.size(), "%zu", number);
        }
        const double share =
            static_cast<double>(pixels[number]) / static_cast<double>(measured.map.size());
        lines.push_back(std::string(sign.data()) + " is " + std::string(text.word) + " (" +
                        number_text(100 * share) +
                        " % of the pixels): " + std::string(text.sentence));
    }
    return lines;
}

MapPicture reason_picture(const Measurement& measured) {
    MapPicture result{Image(measured.picture.width, measured.picture.height),
                      {meaning_of(Measure::ended).text}};
    for (std::size_t k = 0; k < measured.map.size(); ++k) {
        const Colour8 c = reason_colour(static_cast<Reason>(measured.map[k]));
        result.image.set(k, c[0], c[1], c[2]);
    }
    std::ranges::move(reason_lines(measured, true), std::back_inserter(result.legend));
    return result;
}

}  // namespace

std::optional<Measure> map_named(std::string_view word) {
    std::array<std::string_view, meanings.size() + 1> words = {"color"};
    std::ranges::transform(meanings, words.begin() + 1, &Meaning::word);
    const std::size_t k = one_of("--map", word, words);
    return k == 0 ? std::nullopt : std::optional(static_cast<Measure>(k - 1));
}

MapPicture map_picture(const Measurement& measured, Measure measure) {
    return measure == Measure::ended ? reason_picture(measured) : scale_picture(measured, measure);
}

std::vector<std::string> map_values(const Measurement& measured, Measure measure) {
    std::vector<std::string> lines = {meaning_of(measure).text};
    if (measure == Measure::ended) {
        std::ranges::move(reason_lines(measured, false), std::back_inserter(lines));
    } else {
        lines.front() += ", " + range_text(range_of(measured.map, measure), measure);
    }
    return lines;
}

}  // namespace raytree::cli
