#include "formats/word_reader.h"

#include <cmath>
#include <limits>

#include "formats/support.h"

namespace raytree {
namespace {

double parsed(std::string_view word) {
    double number = std::numeric_limits<double>::quiet_NaN();
    return parse_number(word, number) ? number : std::numeric_limits<double>::quiet_NaN();
}

bool is_number(std::string_view word) { return !std::isnan(parsed(word)); }

TEST_CASE("a word is read to the nearest double") {
    CHECK(parsed("0.1") == 0.1);
    CHECK(parsed("-.5") == -0.5);
    CHECK(parsed("+3.") == 3);
    CHECK(parsed("1E+3") == 1000);
    CHECK(parsed("9007199254740993") == 9007199254740992.0);  // a tie, to even
    CHECK(parsed("9007199254740993.0000000000000000000001") == 9007199254740994.0);
    CHECK(parsed("5e-324") == std::numeric_limits<double>::denorm_min());
    CHECK(parsed("1e-999") == 0);
    CHECK(parsed("2.4703282292062327e-324") == 0);
}

TEST_CASE("words that are no finite decimal number are none") {
    for (const char* word : {"", "+", "-", ".", "e5", "1e", "1,5", "1.5x", "0x10", "+-1", "--1",
                             "nan", "inf", "-infinity", "1e999", "-1e400"}) {
        CAPTURE(word);
        CHECK(!is_number(word));
    }
}

TEST_CASE("words know their line and column") {
    WordReader words("one\ttwo # three\n\n  four#five", "f", WordReader::Comments::hash);
    CHECK(words.next().text == "one");
    const Word two = words.peek();
    CHECK(two.text == "two");
    CHECK(two.line == 1);
    CHECK(two.column == 5);
    words.next();
    CHECK(!words.continues(1));
    const Word four = words.next();
    CHECK(four.text == "four");
    CHECK(four.line == 3);
    CHECK(four.column == 3);
    CHECK(words.at_end());
    CHECK(words.next().text.empty());
}

TEST_CASE("where a format has no comments, a hash is a letter") {
    WordReader words("a#b", "f", WordReader::Comments::none);
    CHECK(words.next().text == "a#b");
}

TEST_CASE("a long word is shortened in messages") {
    const std::string long_word(1000, 'x');
    WordReader words(long_word, "f", WordReader::Comments::none);
    const std::string text = test::refusal_of([&] { words.number("a number"); });
    CHECK(text.size() < 150);
    CHECK_CONTAINS(text, "xxx\"..., must be a finite number: a number");
}

}  // namespace
}  // namespace raytree
