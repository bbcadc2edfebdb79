#pragma once

#include <vector>

#include "check/check.h"
#include "check/picture_values.h"

namespace raytree::check {

/// The pixels of a picture that differ from the truth by a rulebook, and those that do not.
struct PictureDifference {
    const Checker& checker;
    const Rulebook& book;
    const Picture& truth;
    const PixelMatch& match;
    const std::vector<PixelPlace>& differing;
    const std::vector<PixelPlace>& agreeing;
};

/// The conventions of other courses that explain the picture; none where none do.
Choices conventions_of(const PictureDifference& difference);
/// The mistakes of the catalogue that do, the likeliest first.
std::vector<NamedMistake> mistakes_of(const PictureDifference& difference);

}  // namespace raytree::check
