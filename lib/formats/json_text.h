#pragma once

#include <concepts>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "math/real.h"
#include "math/rgb.h"
#include "math/vector.h"

/// Writing JSON that people like to read: lists of numbers on one line, small objects on one line
/// as long as they fit into 100 columns, large ones a member a line.
namespace raytree {

/// The shortest decimal that reads back to the same double, as a JSON number; `value` is finite.
std::string json_number(double value);

/// 36 significant digits, which read back to the same binary128, as a JSON number.
std::string json_number(Quad value);

/// `text` as a JSON string with its quotes. UTF-8 passes through; a byte that is none becomes
/// U+FFFD.
std::string json_string(std::string_view text);

/// Writes one JSON document from front to back:
///
///     JsonWriter json;
///     json.begin_object(JsonWriter::Layout::block);
///     json.member("format", "raytree/1.0");
///     json.key("pixel").numbers({320, 240});
///     json.end_object();
///     std::string text = json.take();
///
/// Calls out of turn (a value without a key in an object, an `end_` too many) and numbers that are
/// not finite are assertions.
class JsonWriter {
  public:
    enum class Layout {
        block,  ///< each element on a line of its own, two spaces further in
        fill,   ///< elements side by side, a new line where 100 columns are full; holds no `block`
    };

    JsonWriter& begin_object(Layout layout = Layout::fill) { return begin('{', layout); }
    JsonWriter& begin_array(Layout layout = Layout::fill) { return begin('[', layout); }
    JsonWriter& end_object() { return end('{', '}'); }
    JsonWriter& end_array() { return end('[', ']'); }
    JsonWriter& key(std::string_view name);

    JsonWriter& null() { return atom("null"); }
    /// `json` is one number, string, list of numbers, `true`, `false` or `null`.
    JsonWriter& raw(std::string_view json) { return atom(json); }
    JsonWriter& value(bool truth) { return atom(truth ? "true" : "false"); }
    JsonWriter& value(std::string_view text) { return atom(json_string(text)); }
    JsonWriter& value(const char* text) { return value(std::string_view(text)); }
    template <std::integral I>
    requires(!std::same_as<I, bool>) JsonWriter& value(I number) {
        return atom(std::to_string(number));
    }
    JsonWriter& value(double number) { return atom(json_number(number)); }
    JsonWriter& value(float number) { return value(static_cast<double>(number)); }
    JsonWriter& value(Quad number) { return atom(json_number(number)); }
    template <class T> JsonWriter& value(const Vec3<T>& v) { return numbers({v.x, v.y, v.z}); }
    template <class T> JsonWriter& value(const UnitVec3<T>& v) { return value(v.vec()); }
    /// Always three numbers.
    template <class T> JsonWriter& value(const Rgb<T>& c) { return numbers({c.r, c.g, c.b}); }
    /// `null` for none.
    template <class T> JsonWriter& value(const std::optional<T>& maybe) {
        return maybe ? value(*maybe) : null();
    }

    /// A list of numbers, never broken over lines.
    template <class T> JsonWriter& numbers(std::initializer_list<T> list) {
        return numbers(std::span<const T>(list.begin(), list.size()));
    }
    template <class T> JsonWriter& numbers(std::span<const T> list);

    template <class T> JsonWriter& member(std::string_view name, const T& thing) {
        return key(name).value(thing);
    }

    /// The document, which is complete, ending in a line feed. The writer is empty afterwards.
    std::string take();

  private:
    struct Open {
        char bracket;
        Layout layout;
        std::size_t indent;       ///< column of an element at the start of a line
        std::size_t element = 0;  ///< offset in text_ of the element being written
        bool empty = true;
        bool first_on_line = true;  ///< the element being written
    };

    JsonWriter& begin(char bracket, Layout layout);
    JsonWriter& end(char bracket, char closing);
    JsonWriter& atom(std::string_view text);
    void start_element();
    void start_value();
    void new_line(std::size_t indent);
    void break_before_element();
    void break_before_element_if_too_long();
    std::size_t column() const { return text_.size() - line_start_; }

    std::string text_;
    std::size_t line_start_ = 0;
    std::vector<Open> open_;
    bool after_key_ = false;
};

template <class T> JsonWriter& JsonWriter::numbers(std::span<const T> list) {
    std::string text = "[";
    for (const T& number : list) {
        text += text.size() > 1 ? ", " : "";
        if constexpr (std::integral<T>) {
            text += std::to_string(number);
        } else if constexpr (std::same_as<T, float>) {
            text += json_number(static_cast<double>(number));
        } else {
            text += json_number(number);
        }
    }
    return atom(text + "]");
}

}  // namespace raytree
