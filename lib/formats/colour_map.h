#pragma once

#include <array>
#include <cstdint>

#include "trace/reason.h"

/// The colours of maps: how much as a scale, why as a colour for each reason.
namespace raytree {

using Colour8 = std::array<std::uint8_t, 3>;  ///< sRGB

/// A scale from dark violet (0) over blue and green to yellow (1). Equal steps look equally large,
/// and it reads the same in grey and to the colour-blind: lightness rises evenly.
Colour8 scale_colour(double share);

/// A colour for each reason that ends a ray, distinct to the colour-blind as well (Okabe & Ito,
/// "Color universal design", 2008); black for the other reasons.
Colour8 reason_colour(Reason reason);

}  // namespace raytree
