#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "formats/image.h"
#include "trace/render.h"

namespace raytree::cli {

/// What `render --map` calls a measure; nothing for "color", the picture itself.
std::optional<Measure> map_named(std::string_view word);

/// A map in colours, and the sentences that say what they mean.
struct MapPicture {
    Image image;
    std::vector<std::string> legend;
};

/// `measured.map` is of `measure`.
MapPicture map_picture(const Measurement& measured, Measure measure);

/// The same sentences for whoever gets the values themselves and not colours.
std::vector<std::string> map_values(const Measurement& measured, Measure measure);

}  // namespace raytree::cli
