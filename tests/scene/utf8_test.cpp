#include "scene/utf8.h"

#include <doctest/doctest.h>

#include <string>

#include "scene/input_error.h"

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
    CHECK(legible("end.\u202Egnp") == "end.\uFFFDgnp");  // what follows would be read backwards
    CHECK(legible("a\u2028b\u200B\uFEFFc") == "a\uFFFDb\uFFFD\uFFFDc");
    CHECK(legible("\u0646\u200C\u0647") == "\u0646\u200C\u0647");  // joins letters, is no trick
    CHECK(legible("").empty());
}

TEST_CASE("a message is clean text, whatever the file holds and is called") {
    const InputError error("a\x1B[2Jb.json", "/objects/\xFF", "found '\n'");
    CHECK(std::string(error.what()) == "a\uFFFD[2Jb.json: /objects/\uFFFD: found '\uFFFD'");
}

}  // namespace
}  // namespace raytree
