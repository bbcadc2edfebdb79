#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "math/rgb.h"
#include "scene/scene.h"

namespace raytree {

/// A pixel's 8-bit value; `clamped` says for each channel whether it was outside 0 to 1.
struct EightBit {
    std::array<int, 3> value{};
    std::array<bool, 3> clamped{};
};

/// Here, as a picture asks for it at each of its pixels.
inline EightBit eight_bit(const Rgb<double>& intensity, Quantize quantize) {
    EightBit result;
    const std::array<double, 3> raw = {intensity.r, intensity.g, intensity.b};
    for (std::size_t c = 0; c < 3; ++c) {
        const double scaled = 255 * std::clamp(raw[c], 0.0, 1.0);
        const int floor = static_cast<int>(scaled);
        // Not `&&`: the half is as likely as not.
        const bool up = (quantize == Quantize::round) & (scaled - floor >= 0.5);
        result.value[c] = floor + static_cast<int>(up);
        result.clamped[c] = (raw[c] < 0) | (raw[c] > 1);
    }
    return result;
}

}  // namespace raytree
