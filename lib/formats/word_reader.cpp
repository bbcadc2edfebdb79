#include "formats/word_reader.h"

#include <locale.h>  // newlocale is POSIX, not in <clocale>
#include <stdlib.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>

#include "formats/json_text.h"

namespace raytree {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v'; }
bool ends_word(char c) { return is_blank(c) || c == '\n'; }

/// strtod without the user's locale, whose decimal point may be a comma.
double parse_out_of_range(const std::string& word) {
    static const locale_t plain = newlocale(LC_ALL_MASK, "C", nullptr);
    return strtod_l(word.c_str(), nullptr, plain);
}

}  // namespace

bool parse_number(std::string_view word, double& out) {
    // from_chars takes no plus sign, which people write, and does take the words inf and nan.
    if (word.starts_with('+')) {
        word.remove_prefix(1);
        if (word.starts_with('-')) {
            return false;
        }
    }
    double number = 0;
    const char* const end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, number);
    if (stop != end) {
        return false;
    }
    if (error == std::errc::result_out_of_range) {
        // Too large is no double; too small is 0, the nearest one.
        number = parse_out_of_range(std::string(word));
    } else if (error != std::errc()) {
        return false;
    }
    if (!std::isfinite(number)) {
        return false;
    }
    out = number;
    return true;
}

Word WordReader::peek() const {
    if (only_line_ != 0 && (at_end() || line_ != only_line_)) {
        return {"", only_line_, end_column_};
    }
    std::size_t end = position_;
    while (end < text_.size() && !ends_word(text_[end]) &&
           !(comments_ == Comments::hash && text_[end] == '#')) {
        ++end;
    }
    return {text_.substr(position_, end - position_), line_, position_ - line_start_ + 1};
}

Word WordReader::next() {
    const Word word = peek();
    position_ += word.text.size();
    end_column_ = word.column + word.text.size();
    skip_blanks();
    return word;
}

void WordReader::skip_blanks() {
    while (position_ < text_.size()) {
        const char c = text_[position_];
        if (c == '\n') {
            ++line_;
            line_start_ = position_ + 1;
        } else if (comments_ == Comments::hash && c == '#') {
            position_ = std::min(text_.find('\n', position_), text_.size());
            continue;
        } else if (!is_blank(c)) {
            return;
        }
        ++position_;
    }
}

std::string WordReader::found(const Word& word) const {
    if (word.text.empty()) {
        return only_line_ == 0 ? "found the end of the file" : "found the end of the line";
    }
    constexpr std::size_t longest = 40;
    const bool cut = word.text.size() > longest;
    return "found " + json_string(word.text.substr(0, longest)) + (cut ? "..." : "");
}

double WordReader::number(std::string_view what) {
    const Word word = next();
    double number = 0;
    if (!parse_number(word.text, number)) {
        fail(word, found(word) + ", must be a finite number: " + std::string(what));
    }
    return number;
}

long long WordReader::whole_number(std::string_view what, long long least, long long most) {
    const Word word = next();
    long long number = 0;
    const char* const end = word.text.data() + word.text.size();
    const auto [stop, error] = std::from_chars(word.text.data(), end, number);
    if (error != std::errc() || stop != end || number < least || number > most) {
        fail(word, found(word) + ", must be a whole number from " + std::to_string(least) + " to " +
                       std::to_string(most) + ": " + std::string(what));
    }
    return number;
}

Vec3<double> WordReader::point(std::string_view what) {
    const double x = number(what);
    const double y = number(what);
    const double z = number(what);
    return {x, y, z};
}

Rgb<double> WordReader::colour(std::string_view what) {
    const Vec3<double> rgb = point(what);
    return {rgb.x, rgb.y, rgb.z};
}

bool WordReader::number_follows() const {
    double number = 0;
    return parse_number(peek().text, number);
}

void WordReader::fail(const Word& word, const std::string& text) const {
    throw InputError(file_, place(word), text);
}

std::string WordReader::place(const Word& word) const {
    return "line " + std::to_string(word.line) + ", column " + std::to_string(word.column);
}

}  // namespace raytree
