#include "formats/image.h"

#include <png.h>

#include <bit>
#include <cmath>

#include "scene/input_error.h"
#include "tree/eight_bit.h"
#include "tree/explain.h"

namespace raytree {
namespace {

/// What libpng calls an image: how our bytes lie in memory.
struct PngImage : png_image {
    PngImage() : png_image{} { version = PNG_IMAGE_VERSION; }
    ~PngImage() { png_image_free(this); }
    PngImage(const PngImage&) = delete;
    PngImage& operator=(const PngImage&) = delete;
};

void append_float(std::string& bytes, double value, int width, std::size_t pixel) {
    const float number = static_cast<float>(value);
    if (!std::isfinite(number)) {
        const auto columns = static_cast<std::size_t>(width);
        throw InputError(
            "", "pixel " + std::to_string(pixel % columns) + ',' + std::to_string(pixel / columns),
            number_text(value) + " is beyond the floats that a .pfm file holds");
    }
    const auto bits = std::bit_cast<std::uint32_t>(number);
    for (int shift = 0; shift < 32; shift += 8) {
        bytes += static_cast<char>(bits >> shift);
    }
}

/// Calls `append(bytes, pixel)` for every pixel in the order of a PFM file: the bottom row first.
/// The negative scale in its header says that the floats are little-endian.
template <class Append>
std::string pfm(const char* kind, int channels, int width, int height, Append&& append) {
    std::string bytes = std::string(kind) + '\n' + std::to_string(width) + ' ' +
                        std::to_string(height) + "\n-1.0\n";
    const auto columns = static_cast<std::size_t>(width);
    const auto rows = static_cast<std::size_t>(height);
    bytes.reserve(bytes.size() + columns * rows * 4 * static_cast<std::size_t>(channels));
    for (std::size_t j = rows; j-- > 0;) {
        for (std::size_t i = 0; i < columns; ++i) {
            append(bytes, j * columns + i);
        }
    }
    return bytes;
}

}  // namespace

Image::Image(int w, int h)
    : width(w), height(h), bytes(3 * static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}

QuantizedPicture quantized(const Picture& picture, Quantize quantize) {
    QuantizedPicture result{Image(picture.width, picture.height)};
    for (std::size_t k = 0; k < picture.pixels.size(); ++k) {
        const EightBit pixel = eight_bit(picture.pixels[k], quantize);
        result.image.set(k, static_cast<std::uint8_t>(pixel.value[0]),
                         static_cast<std::uint8_t>(pixel.value[1]),
                         static_cast<std::uint8_t>(pixel.value[2]));
        result.clamped += pixel.clamped[0] || pixel.clamped[1] || pixel.clamped[2] ? 1 : 0;
    }
    return result;
}

std::string encode_png(const Image& image) {
    PngImage png;
    png.width = static_cast<png_uint_32>(image.width);
    png.height = static_cast<png_uint_32>(image.height);
    png.format = PNG_FORMAT_RGB;
    // On traced pictures its usual choice of filters takes thrice the time and gains no bytes.
    png.flags = PNG_IMAGE_FLAG_FAST;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
    std::string bytes(size, '\0');
    if (png_image_write_to_memory(&png, bytes.data(), &size, 0, image.bytes.data(), 0, nullptr) ==
        0) {
        throw InputError("", "PNG", png.message);
    }
    bytes.resize(size);
    return bytes;
}

std::string encode_ppm(const Image& image) {
    std::string bytes =
        "P6\n" + std::to_string(image.width) + ' ' + std::to_string(image.height) + "\n255\n";
    bytes.append(image.bytes.begin(), image.bytes.end());
    return bytes;
}

std::string encode_pfm(const Picture& picture) {
    return pfm("PF", 3, picture.width, picture.height, [&](std::string& bytes, std::size_t pixel) {
        const Rgb<double>& c = picture.pixels[pixel];
        for (const double channel : {c.r, c.g, c.b}) {
            append_float(bytes, channel, picture.width, pixel);
        }
    });
}

std::string encode_pfm(int width, int height, std::span<const double> values) {
    return pfm("Pf", 1, width, height, [&](std::string& bytes, std::size_t pixel) {
        append_float(bytes, values[pixel], width, pixel);
    });
}

Image read_png(std::string_view bytes, const std::string& file) {
    PngImage png;
    if (png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) == 0) {
        throw InputError(file, "", std::string("is no PNG picture: ") + png.message);
    }
    png.format = PNG_FORMAT_RGB;
    Image image(static_cast<int>(png.width), static_cast<int>(png.height));
    const png_color black{0, 0, 0};
    if (png_image_finish_read(&png, &black, image.bytes.data(), 0, nullptr) == 0) {
        throw InputError(file, "", std::string("cannot be read as PNG: ") + png.message);
    }
    return image;
}

}  // namespace raytree
