#include "map_picture.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "formats/measure_map.h"
#include "tree/explain.h"
#include "values.h"

namespace raytree::cli {
namespace {

std::string range_text(const MapRange& range, Measure measure) {
    return range.least == range.beyond ? "all " + measured_text(range.least, measure)
                                       : "from " + measured_text(range.least, measure) + " to " +
                                             measured_text(range.beyond, measure);
}

std::string colours_text(const MapRange& range, Measure measure) {
    std::string colours = "dark violet is " + measured_text(range.least, measure);
    if (range.most > range.least) {
        colours += ", green in between, yellow " + measured_text(range.most, measure);
    }
    if (range.beyond > range.most) {
        colours += " and more: the slowest 1 % of the pixels are clamped";
    }
    return colours;
}

/// One line for each reason that a pixel has, the most frequent first.
std::vector<std::string> reason_lines(const Measurement& measured, bool as_colours) {
    std::vector<std::string> lines;
    for (const auto& [reason, pixels] : reasons_in(measured.map)) {
        const ReasonText& text = raytree::text_of(reason);
        const Colour8 c = reason_colour(reason);
        std::array<char, 16> sign;
        if (as_colours) {
            std::snprintf(sign.data(), sign.size(), "#%02X%02X%02X", c[0], c[1], c[2]);
        } else {
            std::snprintf(sign.data(), sign.size(), "%zu", static_cast<std::size_t>(reason));
        }
        const double share = static_cast<double>(pixels) / static_cast<double>(measured.map.size());
        lines.push_back(std::string(sign.data()) + " is " + std::string(text.word) + " (" +
                        number_text(100 * share) +
                        " % of the pixels): " + std::string(text.sentence));
    }
    return lines;
}

}  // namespace

MapChoice map_named(std::string_view word) {
    constexpr std::array measures = {Measure::rays, Measure::levels, Measure::tests,
                                     Measure::nanoseconds, Measure::ended};
    std::array<std::string_view, measures.size() + 2> words = {"color", "error"};
    std::ranges::transform(measures, words.begin() + 2,
                           [](Measure measure) { return word_of(measure); });
    const std::size_t k = one_of("--map", word, words);
    return k == 0   ? MapChoice{}
           : k == 1 ? MapChoice{std::nullopt, true}
                    : MapChoice{measures[k - 2], false};
}

MapPicture map_picture(const Measurement& measured, Measure measure) {
    const MapRange range = map_range(measured.map, measure);
    MapPicture result{Image(measured.picture.width, measured.picture.height), {}};
    for (std::size_t k = 0; k < measured.map.size(); ++k) {
        const Colour8 c = map_colour(measured.map[k], measure, range);
        result.image.set(k, c[0], c[1], c[2]);
    }
    if (measure == Measure::ended) {
        result.legend = {std::string(raytree::text_of(measure))};
        std::ranges::move(reason_lines(measured, true), std::back_inserter(result.legend));
    } else {
        result.legend = map_values(measured, measure);
        result.legend.push_back(colours_text(range, measure));
    }
    return result;
}

std::vector<std::string> map_values(const Measurement& measured, Measure measure) {
    std::vector<std::string> lines = {std::string(raytree::text_of(measure))};
    if (measure == Measure::ended) {
        std::ranges::move(reason_lines(measured, false), std::back_inserter(lines));
    } else {
        lines.front() += ", " + range_text(map_range(measured.map, measure), measure);
    }
    return lines;
}

MapPicture error_picture(const ErrorMap& map) {
    const ErrorRange range = error_range(map.errors);
    MapPicture result{Image(map.picture.width, map.picture.height), {error_values(map)}};
    for (std::size_t k = 0; k < map.errors.size(); ++k) {
        const Colour8 c = error_colour(map.errors[k], range);
        result.image.set(k, c[0], c[1], c[2]);
    }
    if (range.most > 0) {
        std::string colours = "dark violet is " + number_text(range.least);
        if (range.most > range.least) {
            colours += ", yellow " + number_text(range.most) + ", on a logarithmic scale";
        }
        result.legend.push_back(colours);
    }
    if (range.exact > 0) {
        const double share =
            100 * static_cast<double>(range.exact) / static_cast<double>(map.errors.size());
        result.legend.push_back("black is no difference at all (" + number_text(share) +
                                " % of the pixels)");
    }
    return result;
}

std::string error_values(const ErrorMap& map) {
    const auto [least, most] = std::ranges::minmax(map.errors);
    return "difference of the pixel's intensity from the reference arithmetic, of the channel "
           "farthest off (1 is white), from " +
           number_text(least) + " to " + number_text(most);
}

}  // namespace raytree::cli
