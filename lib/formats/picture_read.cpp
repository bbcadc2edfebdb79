#include "formats/picture_read.h"

#include <bit>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>

#include "formats/image.h"
#include "scene/input_error.h"

namespace raytree {
namespace {

using Size = std::pair<int, int>;

std::string text_of(Size size) {
    return std::to_string(size.first) + " x " + std::to_string(size.second);
}

void expect_size(Size found, Size due, const std::string& file) {
    if (found != due) {
        throw InputError(
            file, "",
            "is a picture of " + text_of(found) + " pixels; the scene's has " + text_of(due));
    }
}

ReadPicture of_bytes(const std::uint8_t* bytes, Size size) {
    ReadPicture picture;
    picture.width = size.first;
    picture.height = size.second;
    picture.pixels.resize(static_cast<std::size_t>(size.first) *
                          static_cast<std::size_t>(size.second));
    for (std::size_t k = 0; k < picture.pixels.size(); ++k) {
        const std::uint8_t* const c = bytes + 3 * k;
        picture.pixels[k] = {static_cast<float>(c[0]) / 255, static_cast<float>(c[1]) / 255,
                             static_cast<float>(c[2]) / 255};
    }
    return picture;
}

std::uint32_t big_endian(std::string_view bytes) {
    std::uint32_t value = 0;
    for (const char c : bytes.substr(0, 4)) {
        value = value << 8 | static_cast<unsigned char>(c);
    }
    return value;
}

ReadPicture of_png(std::string_view bytes, const std::string& file, Size size) {
    if (bytes.size() < 24) {
        throw InputError(file, "", "is cut off: it has no PNG header");
    }
    const auto clipped = [](std::uint32_t n) { return static_cast<int>(std::min(n, 1U << 30)); };
    expect_size({clipped(big_endian(bytes.substr(16))), clipped(big_endian(bytes.substr(20)))},
                size, file);
    return of_bytes(read_png(bytes, file).bytes.data(), size);
}

/// Words of a Netpbm header, with comments between them.
class Header {
  public:
    Header(std::string_view bytes, const std::string& file) : bytes_(bytes), file_(file) {}

    std::string_view word() {
        skip();
        const std::size_t from = at_;
        while (at_ < bytes_.size() && std::isspace(static_cast<unsigned char>(bytes_[at_])) == 0) {
            ++at_;
        }
        return bytes_.substr(from, at_ - from);
    }
    template <class Number> Number number(const char* what) {
        const std::string_view text = word();
        Number value{};
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc() || end != text.data() + text.size() || text.empty()) {
            throw InputError(file_, "byte " + std::to_string(at_ - text.size()),
                             std::string("must be ") + what);
        }
        return value;
    }
    /// What comes after the one white space that ends the header.
    std::string_view rest() const { return bytes_.substr(std::min(at_ + 1, bytes_.size())); }

  private:
    void skip() {
        while (at_ < bytes_.size()) {
            if (bytes_[at_] == '#') {
                at_ = std::min(bytes_.find('\n', at_), bytes_.size());
            } else if (std::isspace(static_cast<unsigned char>(bytes_[at_])) == 0) {
                return;
            } else {
                ++at_;
            }
        }
    }

    std::string_view bytes_;
    const std::string& file_;
    std::size_t at_ = 0;
};

void expect_bytes(std::size_t found, std::size_t due, const std::string& file) {
    if (found < due) {
        throw InputError(file, "",
                         "is cut off: " + std::to_string(found) + " bytes of pixels, must be " +
                             std::to_string(due));
    }
}

ReadPicture of_ppm(std::string_view bytes, const std::string& file, Size size) {
    Header header(bytes, file);
    const bool plain = header.word() == "P3";
    const int width = header.number<int>("the width");
    expect_size({width, header.number<int>("the height")}, size, file);
    if (header.number<int>("the largest value") != 255) {
        throw InputError(file, "", "must have 255 for its largest value");
    }
    const std::size_t count =
        3 * static_cast<std::size_t>(size.first) * static_cast<std::size_t>(size.second);
    if (!plain) {
        const std::string_view rest = header.rest();
        expect_bytes(rest.size(), count, file);
        return of_bytes(reinterpret_cast<const std::uint8_t*>(rest.data()), size);
    }
    std::vector<std::uint8_t> values(count);
    for (std::uint8_t& value : values) {
        value = header.number<std::uint8_t>("a whole number from 0 to 255");
    }
    return of_bytes(values.data(), size);
}

ReadPicture of_pfm(std::string_view bytes, const std::string& file, Size size) {
    Header header(bytes, file);
    const std::size_t channels = header.word() == "PF" ? 3 : 1;
    const int width = header.number<int>("the width");
    expect_size({width, header.number<int>("the height")}, size, file);
    const auto scale = header.number<double>("the scale");
    if (!(std::abs(scale) > 0)) {
        throw InputError(file, "",
                         "must have a scale other than 0: its sign tells the order of the bytes");
    }
    const bool little = scale < 0;
    const std::string_view rest = header.rest();
    const auto columns = static_cast<std::size_t>(size.first);
    const auto rows = static_cast<std::size_t>(size.second);
    expect_bytes(rest.size(), 4 * channels * columns * rows, file);
    ReadPicture picture{size.first, size.second, false, {}};
    picture.pixels.resize(columns * rows);
    for (std::size_t k = 0; k < columns * rows; ++k) {
        const std::size_t pixel = (rows - 1 - k / columns) * columns + k % columns;
        float value[3];
        for (std::size_t c = 0; c < 3; ++c) {
            const std::size_t at = 4 * (channels * k + std::min(c, channels - 1));
            std::uint32_t bits = big_endian(rest.substr(at));
            bits = little ? __builtin_bswap32(bits) : bits;
            value[c] = std::bit_cast<float>(bits);
            if (!std::isfinite(value[c])) {
                throw InputError(file,
                                 "pixel " + std::to_string(pixel % columns) + ',' +
                                     std::to_string(pixel / columns),
                                 "is no number");
            }
        }
        picture.pixels[pixel] = {value[0], value[1], value[2]};
    }
    return picture;
}

}  // namespace

ReadPicture read_picture(std::string_view bytes, const std::string& file, Size size) {
    if (bytes.starts_with("\x89PNG")) {
        return of_png(bytes, file, size);
    }
    if (bytes.starts_with("P6") || bytes.starts_with("P3")) {
        return of_ppm(bytes, file, size);
    }
    if (bytes.starts_with("PF") || bytes.starts_with("Pf")) {
        return of_pfm(bytes, file, size);
    }
    throw InputError(file, "", "is no picture in PNG, PPM (P3 or P6) or PFM");
}

}  // namespace raytree
