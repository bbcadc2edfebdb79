#pragma once

#include <span>
#include <string_view>

#include "check/picture_values.h"

/// Mistakes made with finished colours, which only a picture shows.
namespace raytree::check {

struct PictureMistakeRow {
    std::string_view id;
    std::string_view text;
    std::string_view topic;
    /// The colour, 0 to 1, that a program with it writes into the pixel.
    Spectrum (*colour)(const Picture& truth, PixelPlace at);
};

std::span<const PictureMistakeRow> picture_mistakes();

}  // namespace raytree::check
