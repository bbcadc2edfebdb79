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

/// Whether the picture's pixel is this colour: within one level of 8 bits, or `rtol` of floats.
class PixelMatch {
  public:
    PixelMatch(const ReadPicture& picture, double rtol) : picture_(picture), rtol_(rtol) {}

    bool operator()(PixelPlace at, const Spectrum& colour) const;
    std::size_t misses(const Place& place, const Laws& laws, std::span<const PixelPlace> at,
                       std::size_t enough = ~std::size_t{0}) const;

  private:
    const ReadPicture& picture_;
    double rtol_;
};

/// Whether a ray a thousandth of a pixel away would have the picture's colour: a tie that rounding
/// decides.
bool is_near_tie(const Rulebook& book, const PixelMatch& match, PixelPlace at);

/// All pixels of a picture by a rulebook.
Picture picture_by(const Rulebook& book);

/// `count` pixels spread evenly over `from`, or all of them.
std::vector<PixelPlace> spread(const std::vector<PixelPlace>& from, std::size_t count);

}  // namespace raytree::check
