#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "math/rgb.h"

namespace raytree {

/// A picture that someone else's program wrote.
struct ReadPicture {
    int width = 0;
    int height = 0;
    bool eight_bit = true;           ///< else floats, which may be beyond 0 to 1
    std::vector<Rgb<float>> pixels;  ///< row by row from the top left; of 8 bits: n / 255

    const Rgb<float>& at(int i, int j) const {
        return pixels[static_cast<std::size_t>(j) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(i)];
    }
};

/// Reads PNG, PPM (P3 and P6 of 8 bits) or PFM, told apart by their first bytes. Throws InputError
/// for what is none of them, for numbers that are none, and, before anything is unpacked, for a
/// picture that is not `size` (width, height).
ReadPicture read_picture(std::string_view bytes, const std::string& file, std::pair<int, int> size);

}  // namespace raytree
