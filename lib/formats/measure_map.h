#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "formats/colour_map.h"
#include "trace/render.h"

/// What a map of a measure says: its words, its range, its colours.
namespace raytree {

/// "rays", "levels", "tests", "time" or "ended".
std::string_view word_of(Measure measure);
/// "rays in the pixel's tree, shadow rays too"
std::string_view text_of(Measure measure);
/// A value with its unit.
std::string measured_text(double value, Measure measure);

/// The values that get the first and the last colour. A few pixels during which the machine was
/// busy elsewhere would leave all others dark, so a map of time ends at the slowest hundredth.
struct MapRange {
    double least = 0;
    double most = 0;
    double beyond = 0;  ///< the largest there is
};

/// Of one value or more.
MapRange map_range(const std::vector<double>& values, Measure measure);

/// `value` is one of those that the range is of.
Colour8 map_colour(double value, Measure measure, const MapRange& range);

/// What a map of errors (trace/error_map.h) has: its colours are of the errors' logarithms.
struct ErrorRange {
    double least = 0;  ///< of those that are not 0; 0 where all are
    double most = 0;
    std::size_t exact = 0;  ///< pixels of no error at all
};

ErrorRange error_range(const std::vector<double>& errors);

/// Black for no error at all, dark violet for the least of the others, yellow for the largest.
Colour8 error_colour(double error, const ErrorRange& range);

struct ReasonPixels {
    Reason reason;
    std::size_t pixels;
};

/// The reasons in a map of Measure::ended, the most frequent first.
std::vector<ReasonPixels> reasons_in(const std::vector<double>& map);

}  // namespace raytree
