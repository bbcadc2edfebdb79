#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"
#include "trace/render.h"

/// Pictures as files: PNG and PPM in 8 bits, PFM with floats.
namespace raytree {

/// A picture of 8 bits a channel.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> bytes;  ///< red, green, blue; row by row from the top left

    Image() = default;
    Image(int w, int h);

    std::size_t pixels() const { return bytes.size() / 3; }
    void set(std::size_t pixel, std::uint8_t r, std::uint8_t g, std::uint8_t b) {
        bytes[3 * pixel] = r;
        bytes[3 * pixel + 1] = g;
        bytes[3 * pixel + 2] = b;
    }
    bool operator==(const Image&) const = default;
};

struct QuantizedPicture {
    Image image;
    std::size_t clamped = 0;  ///< pixels with a channel that was below 0 or above 1
};

/// Each channel as 255 times what is left of it between 0 and 1, with no gamma curve (model,
/// section 5).
QuantizedPicture quantized(const Picture& picture, Quantize quantize);

std::string encode_png(const Image& image);
std::string encode_ppm(const Image& image);

/// The intensities as they are, in the floats nearest to them: in colour, or in grey one value for
/// each pixel, row by row from the top left. Throws InputError for a number beyond all floats.
std::string encode_pfm(const Picture& picture);
std::string encode_pfm(int width, int height, std::span<const double> values);

/// The 8-bit channels of a PNG file's bytes. `file` names it in the InputError for what is none.
Image read_png(std::string_view bytes, const std::string& file);

}  // namespace raytree
