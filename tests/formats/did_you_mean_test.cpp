#include "formats/did_you_mean.h"

#include <doctest/doctest.h>

#include <array>

namespace raytree {
namespace {

constexpr std::array<std::string_view, 5> kNames{"color", "center", "radius", "ka", "kd"};

TEST_CASE("a misspelt name finds the one that was meant") {
    CHECK(probably_meant("colour", kNames) == "color");
    CHECK(probably_meant("centre", kNames) == "center");
    CHECK(probably_meant("raduis", kNames) == "radius");
    CHECK(probably_meant("RADIUS", kNames) == "radius");
    CHECK(did_you_mean("colour", kNames) == "; did you mean \"color\"?");
}

TEST_CASE("what is like none of the names finds none") {
    CHECK(probably_meant("transparency", kNames).empty());
    CHECK(probably_meant("xy", kNames).empty());
    CHECK(probably_meant("", kNames).empty());
    CHECK(probably_meant(std::string(100000, 'x'), kNames).empty());
    CHECK(did_you_mean("transparency", kNames).empty());
}

}  // namespace
}  // namespace raytree
