#include "formats/json_parse.h"

#include "formats/support.h"

namespace raytree {
namespace {

using test::refusal_of;

std::string refusal(const std::string& text) {
    return refusal_of([&] { parse_json(text, "f.json"); });
}

TEST_CASE("members keep the order of the text") {
    const Json document = parse_json(R"({"z": 1, "a": [true, null, "x"], "m": -2.5e3})", "f.json");
    CHECK(document.dump() == R"({"z":1,"a":[true,null,"x"],"m":-2500.0})");
}

TEST_CASE("a document that is cut off is refused with its last line and column") {
    CHECK_CONTAINS(refusal("{\n \"a\": [1,"), "f.json: line 2, column ");
    CHECK_CONTAINS(refusal("{\n \"a\": [1,"), "unexpected end of input");
    CHECK_CONTAINS(refusal(""), "unexpected end of input");
}

TEST_CASE("NaN and infinity are no JSON") {
    for (const char* word : {"NaN", "nan", "Infinity", "-Infinity", "inf"}) {
        const std::string text = refusal("{\n  \"radius\": " + std::string(word) + "}");
        CHECK_CONTAINS(text, "f.json: line 2, column ");
        CHECK_CONTAINS(text, "is not JSON");
        CHECK_CONTAINS(text, "no NaN and no infinity");
    }
}

TEST_CASE("a number too large for a double is refused, one too small is 0") {
    CHECK_CONTAINS(refusal("{\"a\": 1e999}"), "f.json: line 1, column ");
    CHECK_CONTAINS(refusal("{\"a\": 1e999}"), "the number 1e999 is too large");
    CHECK(parse_json("1e-999", "f.json").get<double>() == 0);
    CHECK(parse_json("1.7976931348623157e308", "f.json").get<double>() == 1.7976931348623157e308);
}

TEST_CASE("a key that is there twice is refused with its pointer") {
    const auto mistakes = test::mistakes_of(
        [] { parse_json(R"({"a": [{"x": 1, "x": 2}], "b/c": {"~": 1, "~": 1}})", "f.json"); });
    REQUIRE(mistakes.size() == 2);
    CHECK(mistakes[0].place == "/a/0/x");
    CHECK_CONTAINS(mistakes[0].text, "twice");
    CHECK(mistakes[1].place == "/b~1c/~0");
}

TEST_CASE("nesting of 100,000 is refused without trouble") {
    CHECK_CONTAINS(refusal(std::string(100000, '[')), "nested too deep; at most 64");
    std::string objects;
    for (int k = 0; k < 100000; ++k) {
        objects += "{\"a\":";
    }
    CHECK_CONTAINS(refusal(objects), "nested too deep; at most 64");
    const std::string deepest = std::string(64, '[') + std::string(64, ']');
    CHECK(refusal(deepest) == "");
    CHECK(refusal('[' + deepest + ']') != "");
}

TEST_CASE("what follows the document, and what JSON lacks, is refused") {
    CHECK(refusal("{} {}") != "");
    CHECK(refusal("[1,]") != "");
    CHECK(refusal("{'a': 1}") != "");
    CHECK(refusal("[1] // comment") != "");
    CHECK(refusal("[\"\xFF\"]") != "");
}

}  // namespace
}  // namespace raytree
