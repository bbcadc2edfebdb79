#pragma once

#include <span>
#include <vector>

#include "check/rulebook.h"
#include "formats/picture_read.h"
#include "trace/render.h"

/// The colour of a pixel by given laws, and whether a picture has it.
namespace raytree::check {

struct PixelPlace {
    int i = 0, j = 0;
    bool operator==(const PixelPlace&) const = default;
};

/// The intensity of the pixel's tree; not a number where it grows out of range.
Spectrum colour_by(const Place& place, const Laws& laws, PixelPlace at);

/// The exponent of the curve through which colours go on the way to the finished picture; 1: none.
double gamma_of(const Choices& choices);
/// A colour on the other side of the curve: its components to the power of 1 / gamma.
Spectrum through_curve(const Spectrum& colour, double gamma);

/// Whether the picture's pixel is this colour, once it has gone through the curve: within one level
/// of 8 bits, or `rtol` of floats.
class PixelMatch {
  public:
    PixelMatch(const ReadPicture& picture, double rtol, double gamma = 1)
        : picture_(picture), rtol_(rtol), gamma_(gamma) {}

    bool operator()(PixelPlace at, const Spectrum& colour) const;
    std::size_t misses(const Place& place, const Laws& laws, std::span<const PixelPlace> at,
                       std::size_t enough = ~std::size_t{0}) const;

  private:
    const ReadPicture& picture_;
    double rtol_;
    double gamma_;
};

/// Whether a ray a thousandth of a pixel away would have the picture's colour: a tie that rounding
/// decides.
bool is_near_tie(const Rulebook& book, const PixelMatch& match, PixelPlace at);

/// All pixels of a picture by a rulebook.
Picture picture_by(const Rulebook& book);

/// `count` pixels spread evenly over `from`, or all of them.
std::vector<PixelPlace> spread(const std::vector<PixelPlace>& from, std::size_t count);

}  // namespace raytree::check
