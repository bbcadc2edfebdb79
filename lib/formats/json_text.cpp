#include "formats/json_text.h"

#include <array>
#include <cassert>
#include <charconv>
#include <cmath>

#include "scene/utf8.h"

namespace raytree {
namespace {

constexpr std::size_t kColumns = 100;
constexpr std::size_t kIndent = 2;
/// A nested object that would begin further right than this begins on a line of its own.
constexpr std::size_t kLatestNested = 50;

void append_ascii(std::string& out, char c) {
    switch (c) {
        case '"':
            out += "\\\"";
            return;
        case '\\':
            out += "\\\\";
            return;
        case '\n':
            out += "\\n";
            return;
        case '\r':
            out += "\\r";
            return;
        case '\t':
            out += "\\t";
            return;
        default:
            break;
    }
    if (static_cast<unsigned char>(c) >= 0x20) {
        out += c;
        return;
    }
    constexpr std::string_view digits = "0123456789abcdef";
    out += "\\u00";
    out += digits[static_cast<unsigned char>(c) >> 4];
    out += digits[static_cast<unsigned char>(c) & 15];
}

}  // namespace

std::string json_number(double value) {
    assert(std::isfinite(value));
    if (value == 0 && std::signbit(value)) {
        return "-0.0";  // readers take -0 for the integer, which has no sign
    }
    std::array<char, 32> buffer;
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return {buffer.data(), result.ptr};
}

std::string json_number(Quad value) {
    assert(isfinite(value));
    if (value == 0) {
        return signbitq(value) != 0 ? "-0.0" : "0";
    }
    std::array<char, 64> buffer;
    const int length = quadmath_snprintf(buffer.data(), buffer.size(), "%.36Qg", value);
    return {buffer.data(), static_cast<std::size_t>(length)};
}

std::string json_string(std::string_view text) {
    std::string out = "\"";
    while (!text.empty()) {
        const std::size_t length = utf8_length(text);
        if (length == 0) {
            out += "\xEF\xBF\xBD";
        } else if (length == 1) {
            append_ascii(out, text[0]);
        } else {
            out += text.substr(0, length);
        }
        text.remove_prefix(length == 0 ? 1 : length);
    }
    return out + '"';
}

JsonWriter& JsonWriter::begin(char bracket, Layout layout) {
    const bool nested_in_fill = !open_.empty() && open_.back().layout == Layout::fill;
    assert(!(nested_in_fill && layout == Layout::block));
    start_value();
    if (nested_in_fill && column() > kLatestNested && !open_.back().first_on_line) {
        break_before_element();
    }
    text_ += bracket;
    const std::size_t outer_indent = open_.empty() ? 0 : open_.back().indent;
    open_.push_back({bracket, layout, layout == Layout::fill ? column() : outer_indent + kIndent});
    return *this;
}

JsonWriter& JsonWriter::end([[maybe_unused]] char bracket, char closing) {
    assert(!open_.empty() && open_.back().bracket == bracket && !after_key_);
    const Open closed = open_.back();
    open_.pop_back();
    if (closed.layout == Layout::block && !closed.empty) {
        new_line(closed.indent - kIndent);
    }
    text_ += closing;
    return *this;
}

JsonWriter& JsonWriter::key(std::string_view name) {
    assert(!open_.empty() && open_.back().bracket == '{' && !after_key_);
    start_element();
    text_ += json_string(name) + ": ";
    after_key_ = true;
    return *this;
}

JsonWriter& JsonWriter::atom(std::string_view text) {
    start_value();
    text_ += text;
    break_before_element_if_too_long();
    return *this;
}

void JsonWriter::start_value() {
    if (after_key_) {
        after_key_ = false;
    } else if (!open_.empty()) {
        assert(open_.back().bracket == '[');
        start_element();
    } else {
        assert(text_.empty());
    }
}

void JsonWriter::start_element() {
    Open& open = open_.back();
    if (!open.empty) {
        text_ += ',';
    }
    if (open.layout == Layout::block) {
        new_line(open.indent);
    } else if (!open.empty) {
        text_ += ' ';
    }
    open.first_on_line = open.empty || open.layout == Layout::block;
    open.empty = false;
    open.element = text_.size();
}

void JsonWriter::new_line(std::size_t indent) {
    text_ += '\n';
    line_start_ = text_.size();
    text_.append(indent, ' ');
}

/// An element is known to be too long only once it is there. Columns are kept for a comma and for
/// all the brackets that may be closed right after it.
void JsonWriter::break_before_element_if_too_long() {
    std::size_t brackets = 0;
    while (brackets < open_.size() && open_[open_.size() - 1 - brackets].layout == Layout::fill) {
        ++brackets;
    }
    if (brackets > 0 && !open_.back().first_on_line && column() + brackets >= kColumns) {
        break_before_element();
    }
}

void JsonWriter::break_before_element() {
    Open& open = open_.back();
    text_.replace(open.element - 1, 1, "\n" + std::string(open.indent, ' '));
    line_start_ = open.element;
    open.element += open.indent;
    open.first_on_line = true;
}

std::string JsonWriter::take() {
    assert(open_.empty() && !text_.empty() && !after_key_);
    std::string text = std::move(text_);
    text += '\n';
    *this = JsonWriter();
    return text;
}

}  // namespace raytree
