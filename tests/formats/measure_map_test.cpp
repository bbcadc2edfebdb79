#include "formats/measure_map.h"

#include <doctest/doctest.h>

using namespace raytree;

TEST_CASE("map of errors: colours are of logarithms, and black is no error at all") {
    const ErrorRange range = error_range({1e-14, 0, 1e-16, 1e-12, 0});
    CHECK(range.least == 1e-16);
    CHECK(range.most == 1e-12);
    CHECK(range.exact == 2);
    CHECK(error_colour(0, range) == Colour8{0, 0, 0});
    CHECK(error_colour(1e-16, range) == scale_colour(0));
    CHECK(error_colour(1e-14, range) == scale_colour(0.5));
    CHECK(error_colour(1e-12, range) == scale_colour(1));
}

TEST_CASE("map of errors: one error, or none") {
    CHECK(error_colour(3e-17, error_range({3e-17, 3e-17})) == scale_colour(0));
    const ErrorRange none = error_range({0, 0});
    CHECK(none.most == 0);
    CHECK(none.exact == 2);
    CHECK(error_colour(0, none) == Colour8{0, 0, 0});
}
