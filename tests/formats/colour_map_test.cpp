#include "formats/colour_map.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace raytree {
namespace {

double linear(std::uint8_t channel) {
    const double x = channel / 255.0;
    return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}

/// Lightness and the two colour axes of OKLab (Ottosson, 2020).
std::array<double, 3> oklab(const Colour8& c) {
    const double r = linear(c[0]), g = linear(c[1]), b = linear(c[2]);
    const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
    const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
    const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

double difference(const Colour8& x, const Colour8& y) {
    const auto p = oklab(x), q = oklab(y);
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

}  // namespace

TEST_CASE("colour map: equal steps of the scale look equally large") {
    constexpr int steps = 20;
    double least = 1, most = 0;
    for (int k = 0; k < steps; ++k) {
        const double step =
            difference(scale_colour(double(k) / steps), scale_colour(double(k + 1) / steps));
        least = std::min(least, step);
        most = std::max(most, step);
    }
    CHECK(most < 1.2 * least);
}

TEST_CASE("colour map: lightness rises evenly, so that the scale reads the same in grey") {
    for (int k = 0; k <= 100; ++k) {
        const double share = k / 100.0;
        CHECK(oklab(scale_colour(share))[0] == doctest::Approx(0.22 + 0.71 * share).epsilon(0.02));
    }
}

TEST_CASE("colour map: what is beyond the scale has the colour of its end") {
    CHECK(scale_colour(-3) == scale_colour(0));
    CHECK(scale_colour(7) == scale_colour(1));
}

TEST_CASE("colour map: every reason that ends a ray has a colour of its own") {
    std::set<Colour8> colours;
    for (const Reason reason :
         {Reason::total_internal_reflection, Reason::max_depth, Reason::low_intensity,
          Reason::ray_budget, Reason::no_intersection, Reason::max_distance, Reason::opaque}) {
        for (const Colour8& other : colours) {
            CHECK(difference(reason_colour(reason), other) > 0.05);
        }
        colours.insert(reason_colour(reason));
    }
    CHECK(colours.size() == 7);
    CHECK(reason_colour(Reason::surface_unlit) == Colour8{0, 0, 0});
}

}  // namespace raytree
