#include "formats/utf8.h"

#include <doctest/doctest.h>

namespace raytree {
namespace {

TEST_CASE("what a message quotes from a file is UTF-8 without control characters") {
    CHECK(legible("kr = 0.5 \u00B7 \u03B8 \U0001F600") == "kr = 0.5 \u00B7 \u03B8 \U0001F600");
    CHECK(legible("a\nb\x1B[2Jc\x7F") == "a\uFFFDb\uFFFD[2Jc\uFFFD");
    CHECK(legible("caf\xE9!") == "caf\uFFFD!");
    CHECK(legible("\xC2\x9B"
                  "31m") ==
          "\uFFFD"
          "31m");                                            // U+009B is another form of ESC [
    CHECK(legible("\xED\xA0\x80") == "\uFFFD\uFFFD\uFFFD");  // a surrogate
    CHECK(legible("end \xE2\x82") == "end \uFFFD\uFFFD");
    CHECK(legible("").empty());
}

}  // namespace
}  // namespace raytree
