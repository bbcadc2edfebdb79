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

std::optional<Measure> map_named(std::string_view word) {
    constexpr std::array measures = {Measure::rays, Measure::levels, Measure::tests,
                                     Measure::nanoseconds, Measure::ended};
    std::array<std::string_view, measures.size() + 1> words = {"color"};
    std::ranges::transform(measures, words.begin() + 1,
                           [](Measure measure) { return word_of(measure); });
    const std::size_t k = one_of("--map", word, words);
    return k == 0 ? std::nullopt : std::optional(measures[k - 1]);
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

}  // namespace raytree::cli
