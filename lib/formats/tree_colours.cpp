#include "formats/tree_colours.h"

#include <algorithm>
#include <cmath>

#include "tree/eight_bit.h"
#include "tree/explain.h"

namespace raytree {

const RayColours& look_of(const TreeRay<double>& ray) {
    switch (ray.kind) {
        case RayKind::primary:
            return primary_look;
        case RayKind::reflected:
            return reflected_look;
        case RayKind::refracted:
            return refracted_look;
        case RayKind::shadow:
            break;
    }
    return reaches_light(ray) ? lit_look : blocked_look;
}

double thickness_of(const Rgb<double>& weight) {
    return 1 + 5 * std::sqrt(std::clamp(largest_component(weight), 0.0, 1.0));
}

std::string swatch_colour(const Rgb<double>& intensity, Quantize quantize) {
    constexpr std::string_view digits = "0123456789ABCDEF";
    std::string colour = "#";
    for (const int value : eight_bit(intensity, quantize).value) {
        colour += digits[static_cast<std::size_t>(value / 16)];
        colour += digits[static_cast<std::size_t>(value % 16)];
    }
    return colour;
}

}  // namespace raytree
