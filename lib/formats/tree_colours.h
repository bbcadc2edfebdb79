#pragma once

#include <string>

#include "tree/ray_tree.h"

namespace raytree {

/// How the rays of one kind are drawn on white paper. Colours are "#RRGGBB".
struct RayColours {
    const char* line;
    const char* text;    ///< darker where the line's colour is too pale for letters
    const char* fill;    ///< of a frame
    const char* dashes;  ///< as of SVG's stroke-dasharray; empty: solid
};

inline constexpr RayColours primary_look{"#2B3440", "#2B3440", "#F2F4F7", ""};
inline constexpr RayColours reflected_look{"#E07B00", "#9A5400", "#FFF6EB", ""};
inline constexpr RayColours refracted_look{"#0B84C6", "#075F90", "#EDF7FD", ""};
inline constexpr RayColours lit_look{"#B59A1E", "#6E5D0C", "#FFFFFF", "5 3"};
inline constexpr RayColours blocked_look{"#9B2226", "#9B2226", "#FFFFFF", "5 3"};
inline constexpr RayColours absent_look{"#98A2AE", "#6B7683", "#FFFFFF", "1.5 3"};

const RayColours& look_of(const TreeRay<double>& ray);

/// Of a line, in CSS pixels: 1 to 6, by the ray's share of the pixel.
double thickness_of(const Rgb<double>& weight);

/// The colour "#RRGGBB" that a pixel of this intensity has.
std::string swatch_colour(const Rgb<double>& intensity, Quantize quantize);

}  // namespace raytree
