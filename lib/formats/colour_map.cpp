#include "formats/colour_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytree {
namespace {

/// Chroma that sRGB can show at each quarter of the scale, where lightness and hue go evenly from
/// one end to the other. The space is OKLab (Ottosson, 2020).
constexpr std::array<double, 5> chroma = {0.11, 0.095, 0.088, 0.12, 0.14};
constexpr double darkest = 0.22, lightest = 0.93;
constexpr double violet = 295, yellow = 108;  // degrees of hue

double chroma_at(double share) {
    const double place = share * (chroma.size() - 1);
    const auto k = std::min(static_cast<std::size_t>(place), chroma.size() - 2);
    return std::lerp(chroma[k], chroma[k + 1], place - static_cast<double>(k));
}

std::uint8_t srgb(double linear) {
    const double x = std::clamp(linear, 0.0, 1.0);
    const double encoded = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::lround(255 * encoded));
}

Colour8 from_oklab(double lightness, double a, double b) {
    const auto cube = [](double x) { return x * x * x; };
    const double l = cube(lightness + 0.3963377774 * a + 0.2158037573 * b);
    const double m = cube(lightness - 0.1055613458 * a - 0.0638541728 * b);
    const double s = cube(lightness - 0.0894841775 * a - 1.2914855480 * b);
    return {srgb(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
            srgb(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
            srgb(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

}  // namespace

Colour8 scale_colour(double share) {
    const double u = std::clamp(share, 0.0, 1.0);
    const double hue = std::lerp(violet, yellow, u) * std::numbers::pi / 180;
    const double c = chroma_at(u);
    return from_oklab(std::lerp(darkest, lightest, u), c * std::cos(hue), c * std::sin(hue));
}

Colour8 reason_colour(Reason reason) {
    switch (reason) {
        case Reason::opaque:
            return {0x99, 0x99, 0x99};
        case Reason::no_intersection:
            return {0x56, 0xB4, 0xE9};
        case Reason::max_distance:
            return {0x00, 0x72, 0xB2};
        case Reason::max_depth:
            return {0xD5, 0x5E, 0x00};
        case Reason::low_intensity:
            return {0xE6, 0x9F, 0x00};
        case Reason::ray_budget:
            return {0xF0, 0xE4, 0x42};
        case Reason::total_internal_reflection:
            return {0xCC, 0x79, 0xA7};
        default:
            return {0, 0, 0};
    }
}

}  // namespace raytree
