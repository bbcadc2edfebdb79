#include "formats/image.h"

#include <cmath>
#include <cstring>

#include "formats/support.h"

namespace raytree {
namespace {

using test::refusal_of;

Picture picture(int width, int height) {
    Picture result{width, height, {}};
    result.pixels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    return result;
}

Image gradient(int width, int height) {
    Image image(width, height);
    for (std::size_t k = 0; k < image.bytes.size(); ++k) {
        image.bytes[k] = static_cast<std::uint8_t>(k * 7 + k / 5);
    }
    return image;
}

/// The little-endian float at byte `offset`.
float float_at(const std::string& bytes, std::size_t offset) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        bits |= std::uint32_t{static_cast<std::uint8_t>(bytes[offset + k])} << (8 * k);
    }
    float value;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

}  // namespace

TEST_CASE("image: channels become bytes by rounding or by their floor") {
    Picture p = picture(3, 1);
    p.pixels = {{0, 0.5, 1}, {0.1, 0.2, 0.3}, {1.0 / 255, 1.5 / 255, 1.49 / 255}};
    CHECK(quantized(p, Quantize::round).image.bytes ==
          std::vector<std::uint8_t>{0, 128, 255, 26, 51, 77, 1, 2, 1});
    CHECK(quantized(p, Quantize::floor).image.bytes ==
          std::vector<std::uint8_t>{0, 127, 255, 25, 51, 76, 1, 1, 1});
    CHECK(quantized(p, Quantize::round).clamped == 0);
}

TEST_CASE("image: what is clamped is counted by pixel") {
    Picture p = picture(2, 2);
    p.pixels = {{-0.1, 0.5, 2}, {1, 1, 1}, {0, 1.0000001, 0}, {1e300, -1e300, 0}};
    const QuantizedPicture q = quantized(p, Quantize::round);
    CHECK(q.clamped == 3);
    CHECK(q.image.bytes ==
          std::vector<std::uint8_t>{0, 128, 255, 255, 255, 255, 0, 255, 0, 255, 0, 0});
}

TEST_CASE("image: a PNG file holds every byte") {
    for (const auto& [width, height] : {std::pair(1, 1), {7, 5}, {640, 3}, {1, 300}}) {
        const Image image = gradient(width, height);
        const std::string bytes = encode_png(image);
        CHECK(bytes.starts_with("\x89PNG\r\n"));
        CHECK(read_png(bytes, "p.png") == image);
        CHECK(encode_png(image) == bytes);
    }
}

TEST_CASE("image: a file that is no PNG, or is cut off, is refused by name") {
    CHECK_CONTAINS(refusal_of([] { read_png("P6\n1 1\n255\nabc", "p.png"); }), "p.png");
    const std::string whole = encode_png(gradient(20, 20));
    for (const std::size_t size : {std::size_t{0}, std::size_t{20}, whole.size() / 2}) {
        CHECK_CONTAINS(refusal_of([&] { read_png(whole.substr(0, size), "p.png"); }), "p.png");
    }
}

TEST_CASE("image: PPM is a header and the bytes") {
    const std::string bytes = encode_ppm(gradient(2, 1));
    CHECK(bytes.starts_with("P6\n2 1\n255\n"));
    CHECK(bytes.size() == 11 + 6);
    CHECK(static_cast<std::uint8_t>(bytes[12]) == 7);
}

TEST_CASE("image: PFM holds unclamped little-endian floats, the bottom row first") {
    Picture p = picture(2, 2);
    p.pixels = {{1, 2, 3}, {4, 5, 6}, {-7.5, 1e30, 0.1}, {10, 11, 12}};
    const std::string bytes = encode_pfm(p);
    const std::string header = "PF\n2 2\n-1.0\n";
    REQUIRE(bytes.starts_with(header));
    REQUIRE(bytes.size() == header.size() + 4 * 12);
    CHECK(float_at(bytes, header.size()) == -7.5f);
    CHECK(float_at(bytes, header.size() + 4) == 1e30f);
    CHECK(float_at(bytes, header.size() + 8) == 0.1f);
    CHECK(float_at(bytes, header.size() + 24) == 1.0f);
    CHECK(float_at(bytes, header.size() + 44) == 6.0f);
}

TEST_CASE("image: PFM in grey has one float for each pixel") {
    const std::vector<double> values = {1, 2, 3, 4};
    const std::string bytes = encode_pfm(2, 2, values);
    const std::string header = "Pf\n2 2\n-1.0\n";
    REQUIRE(bytes.starts_with(header));
    REQUIRE(bytes.size() == header.size() + 4 * 4);
    CHECK(float_at(bytes, header.size()) == 3.0f);
    CHECK(float_at(bytes, header.size() + 12) == 2.0f);
}

TEST_CASE("image: PFM refuses what no float holds and names the pixel") {
    Picture p = picture(3, 2);
    p.pixels[4] = {0, 1e39, 0};
    CHECK_CONTAINS(refusal_of([&] { encode_pfm(p); }), "pixel 1,1");
}

}  // namespace raytree
