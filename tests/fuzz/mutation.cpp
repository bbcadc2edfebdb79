#include "mutation.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

namespace raytree::fuzz {
namespace {

constexpr std::array<std::string_view, 44> words{"0",
                                                 "-0",
                                                 "-1",
                                                 "1",
                                                 "1e308",
                                                 "-1e308",
                                                 "1e309",
                                                 "1e-320",
                                                 "5e-324",
                                                 "1e99999999999",
                                                 "2147483648",
                                                 "-2147483649",
                                                 "18446744073709551616",
                                                 "0.1e",
                                                 "1e",
                                                 ".",
                                                 "-",
                                                 "+1",
                                                 "0x10",
                                                 "1_000",
                                                 "1,5",
                                                 "NaN",
                                                 "nan",
                                                 "inf",
                                                 "-Infinity",
                                                 "null",
                                                 "true",
                                                 "\"\"",
                                                 "\"1\"",
                                                 "[]",
                                                 "{}",
                                                 "[[]]",
                                                 "[1,2,3,4]",
                                                 "\"\\u0000\"",
                                                 "\"\\ud800\"",
                                                 "\xff\xfe",
                                                 "\xed\xa0\x80",
                                                 "\x1b[31m",
                                                 "a/b",
                                                 "-1/-1/-1",
                                                 "999999999",
                                                 "#",
                                                 "\"x\": 1, \"x\": 2",
                                                 "\t\v\f"};

/// A range of `text` of at most `longest` bytes.
struct Range {
    std::size_t begin, length;
};
Range range_in(Random& random, const std::string& text, std::size_t longest) {
    const std::size_t begin = random.below(text.size());
    return {begin, random.below(std::min(longest, text.size() - begin) + 1)};
}

bool of_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-' || c == '+';
}

/// The word at or after a random place.
Range word_in(Random& random, const std::string& text) {
    std::size_t begin = random.below(text.size());
    while (begin < text.size() && !of_word(text[begin])) {
        ++begin;
    }
    while (begin > 0 && begin < text.size() && of_word(text[begin - 1])) {
        --begin;
    }
    std::size_t end = begin;
    while (end < text.size() && of_word(text[end])) {
        ++end;
    }
    return {begin, end - begin};
}

/// The line at a random place, with its line feed.
Range line_in(Random& random, const std::string& text) {
    const std::size_t at = random.below(text.size());
    const std::size_t before = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
    const std::size_t begin = before == std::string::npos ? 0 : before + 1;
    const std::size_t after = text.find('\n', at);
    return {begin, (after == std::string::npos ? text.size() : after + 1) - begin};
}

void nest(Random& random, std::string& text) {
    const std::size_t depth = 1 + random.below(3000);
    const bool lists = random.below(2) == 0;
    std::string inside;
    for (std::size_t k = 0; k < depth; ++k) {
        inside += lists ? "[" : "{\"a\":";
    }
    if (random.below(2) == 0) {
        inside += lists ? "" : "1";
        inside += std::string(depth, lists ? ']' : '}');
    }
    const Range at = word_in(random, text);
    text.replace(at.begin, at.length, inside);
}

void mutate_once(Random& random, std::string& text, std::span<const std::string> seeds) {
    if (text.empty()) {
        text = words[random.below(words.size())];
        return;
    }
    const std::string& other = seeds[random.below(seeds.size())];
    switch (random.below(12)) {
        case 0:
            text[random.below(text.size())] = static_cast<char>(random.below(256));
            return;
        case 1: {
            const Range lost = range_in(random, text, 200);
            text.erase(lost.begin, lost.length);
            return;
        }
        case 2: {
            const Range twice = range_in(random, text, 200);
            text.insert(random.below(text.size()), text.substr(twice.begin, twice.length));
            return;
        }
        case 3:
            text.resize(random.below(text.size()));
            return;
        case 4: {
            const Range line = line_in(random, text);
            const std::string moved = text.substr(line.begin, line.length);
            text.erase(line.begin, line.length);
            text.insert(line_in(random, text).begin, moved);
            return;
        }
        case 5: {
            const Range line = line_in(random, text);
            text.insert(line.begin, text.substr(line.begin, line.length));
            return;
        }
        case 6: {
            const Range taken = range_in(random, other, 400);
            text.insert(random.below(text.size()), other.substr(taken.begin, taken.length));
            return;
        }
        case 7: {
            const Range from = word_in(random, text);
            const Range to = word_in(random, other);
            text.replace(from.begin, from.length, other.substr(to.begin, to.length));
            return;
        }
        case 8:
            nest(random, text);
            return;
        default: {
            const Range from = word_in(random, text);
            text.replace(from.begin, from.length, words[random.below(words.size())]);
            return;
        }
    }
}

using Json = nlohmann::ordered_json;

void find_values(const Json& value, const Json::json_pointer& at,
                 std::vector<Json::json_pointer>& found) {
    found.push_back(at);
    if (value.is_array()) {
        for (std::size_t k = 0; k < value.size(); ++k) {
            find_values(value[k], at / k, found);
        }
    } else if (value.is_object()) {
        for (const auto& [key, part] : value.items()) {
            find_values(part, at / key, found);
        }
    }
}

Json::json_pointer place_in(Random& random, const Json& document) {
    std::vector<Json::json_pointer> places;
    find_values(document, Json::json_pointer(), places);
    return places[random.below(places.size())];
}

const std::vector<Json>& odd_values() {
    static const std::vector<Json> values{nullptr,
                                          true,
                                          false,
                                          0,
                                          -0.0,
                                          -1,
                                          1,
                                          2,
                                          1e308,
                                          -1e308,
                                          5e-324,
                                          1e-200,
                                          1e200,
                                          4294967296,
                                          -9223372036854775807 - 1,
                                          18446744073709551615U,
                                          0.5,
                                          64,
                                          65,
                                          1000000,
                                          "",
                                          "1",
                                          "a/b~c",
                                          "../../etc/passwd",
                                          std::string(2000, 'x'),
                                          Json::array(),
                                          Json::object(),
                                          Json::array({0, 0, 0}),
                                          Json::array({1, 2}),
                                          Json::array({1e300, -1e300, 1e300}),
                                          Json::array({nullptr}),
                                          Json::object({{"type", "sphere"}})};
    return values;
}

void mutate_value(Random& random, Json& document, const Json& other) {
    const Json::json_pointer at = place_in(random, document);
    switch (random.below(5)) {
        case 0:
            if (!at.empty()) {
                Json& parent = document[at.parent_pointer()];
                if (parent.is_array()) {
                    parent.erase(std::stoul(at.back()));
                } else {
                    parent.erase(at.back());
                }
            }
            return;
        case 1: {
            const Json taken = other[place_in(random, other)];
            document[at] = taken;
            return;
        }
        case 2: {
            const Json::json_pointer from = place_in(random, document);
            const Json taken = document[from];
            document[at] = taken;
            return;
        }
        case 3: {
            Json& value = document[at];
            if (value.is_array() && !value.empty()) {
                const Json again = value[random.below(value.size())];
                value.push_back(again);
            } else if (value.is_object()) {
                value["unknown"] = 1;
            }
            return;
        }
        default:
            document[at] = odd_values()[random.below(odd_values().size())];
            return;
    }
}

}  // namespace

std::string mutated(Random& random, std::span<const std::string> seeds, std::size_t which) {
    std::string text = seeds[which];
    for (std::size_t left = 1 + random.below(4); left > 0; --left) {
        mutate_once(random, text, seeds);
    }
    return text;
}

std::string mutated_json(Random& random, std::span<const std::string> seeds, std::size_t which) {
    Json document = Json::parse(seeds[which]);
    const Json other = Json::parse(seeds[random.below(seeds.size())]);
    for (std::size_t left = 1 + random.below(3); left > 0; --left) {
        mutate_value(random, document, other);
    }
    return document.dump();
}

}  // namespace raytree::fuzz
