#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "formats/image.h"
#include "trace/error_map.h"
#include "trace/render.h"

namespace raytree::cli {

/// What `render --map` is to show: the picture itself ("color"), a measure, or the error of
/// rounding.
struct MapChoice {
    std::optional<Measure> measure;
    bool error = false;
};

MapChoice map_named(std::string_view word);

/// A map in colours, and the sentences that say what they mean.
struct MapPicture {
    Image image;
    std::vector<std::string> legend;
};

/// `measured.map` is of `measure`.
MapPicture map_picture(const Measurement& measured, Measure measure);

MapPicture error_picture(const ErrorMap& map);

/// The same sentences for whoever gets the values themselves and not colours.
std::vector<std::string> map_values(const Measurement& measured, Measure measure);
std::string error_values(const ErrorMap& map);

}  // namespace raytree::cli
