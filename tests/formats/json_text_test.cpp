#include "formats/json_text.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

namespace raytree {
namespace {

using Layout = JsonWriter::Layout;

TEST_CASE("a double is written with the fewest digits that read back to it") {
    CHECK(json_number(0.1) == "0.1");
    CHECK(json_number(1.0) == "1");
    CHECK(json_number(-2.5) == "-2.5");
    CHECK(json_number(1e300) == "1e+300");
    CHECK(json_number(0.1 + 0.2) == "0.30000000000000004");
    CHECK(json_number(5e-324) == "5e-324");
}

TEST_CASE("minus zero keeps its sign when it is read back") {
    const double zero = nlohmann::json::parse(json_number(-0.0)).get<double>();
    CHECK(zero == 0);
    CHECK(std::signbit(zero));
    CHECK(json_number(-Quad(0)) == "-0.0");
}

TEST_CASE("every double reads back to itself") {
    std::mt19937_64 random(20240601);
    for (int k = 0; k < 20000; ++k) {
        const std::uint64_t bits = random();
        double number = 0;
        static_assert(sizeof bits == sizeof number);
        std::memcpy(&number, &bits, sizeof number);
        if (std::isfinite(number)) {
            CHECK(nlohmann::json::parse(json_number(number)).get<double>() == number);
        }
    }
}

TEST_CASE("a reference number is written with 36 digits that read back to it") {
    const Quad third = Quad(1) / 3;
    CHECK(json_number(third) == "0.333333333333333333333333333333333317");
    CHECK(strtoflt128(json_number(third).c_str(), nullptr) == third);
    CHECK(json_number(Quad(2)) == "2");
}

TEST_CASE("strings are escaped and UTF-8 passes through") {
    CHECK(json_string("a\"b\\c") == R"("a\"b\\c")");
    CHECK(json_string("\n\t\r\x01\x1f") == R"("\n\t\r\u0001\u001f")");
    CHECK(json_string("\xCE\xB8 \xE2\x86\x92 \xF0\x9F\x94\xAD") ==
          "\"\xCE\xB8 \xE2\x86\x92 \xF0\x9F\x94\xAD\"");
}

TEST_CASE("bytes that are no UTF-8 become replacement characters") {
    const std::string replacement = "\xEF\xBF\xBD";
    CHECK(json_string("a\xFFz") == "\"a" + replacement + "z\"");
    CHECK(json_string("\xC0\xAF") == '"' + replacement + replacement + '"');  // overlong
    CHECK(json_string("\xED\xA0\x80") == '"' + replacement + replacement + replacement + '"');
    CHECK(json_string("\xE2\x86") == '"' + replacement + replacement + '"');  // cut off
    CHECK(json_string("\xF5\x80\x80\x80").size() == 2 + 4 * replacement.size());
}

TEST_CASE("a block has a line for each element, a filled object has one line") {
    JsonWriter json;
    json.begin_object(Layout::block);
    json.member("name", "x").member("pixel", Vec3<double>(1, 2, 0.5));
    json.key("rays").begin_array(Layout::block);
    json.begin_object().member("id", 0).member("parent", std::optional<int>()).end_object();
    json.begin_object().member("id", 1u).member("seen", true).end_object();
    json.end_array();
    json.key("none").begin_array(Layout::block).end_array();
    json.end_object();
    CHECK(json.take() == R"({
  "name": "x",
  "pixel": [1, 2, 0.5],
  "rays": [
    {"id": 0, "parent": null},
    {"id": 1, "seen": true}
  ],
  "none": []
}
)");
}

TEST_CASE("what does not fit into 100 columns continues below its like") {
    JsonWriter json;
    json.begin_object().key("list").begin_array();
    for (int k = 0; k < 40; ++k) {
        json.value(1000 + k);
    }
    json.end_array().end_object();
    const std::string text = json.take();
    CHECK(nlohmann::json::parse(text)["list"].size() == 40);
    CHECK(text.find("\n          10") != std::string::npos);
    std::size_t start = 0;
    while (start < text.size()) {
        const std::size_t end = text.find('\n', start);
        CHECK(end - start <= 100);
        start = end + 1;
    }
}

TEST_CASE("numbers of all arithmetics are written alike") {
    JsonWriter json;
    json.begin_array().value(0.5F).value(0.5).value(Quad(0.5));
    json.value(Rgb<Quad>(Quad(1), Quad(2), Quad(0.25))).numbers({1.5F, 2.0F}).end_array();
    CHECK(json.take() == "[0.5, 0.5, 0.5, [1, 2, 0.25], [1.5, 2]]\n");
}

}  // namespace
}  // namespace raytree
