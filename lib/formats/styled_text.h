#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace raytree {

/// What a piece of text is, for terminals that show colours. Nothing is told by colour alone.
enum class Style { plain, heading, label, primary, reflected, refracted, lit, blocked, absent };

struct Span {
    Style style = Style::plain;
    std::string text;
};
using Spans = std::vector<Span>;

/// The number of columns that UTF-8 text takes up: its characters, none of which is wide here.
std::size_t columns_of(std::string_view text);
/// `text` with blanks after it up to `columns`.
std::string padded(std::string_view text, std::size_t columns);

/// Lines of text, broken between words where they would be too long, with or without colours.
class StyledText {
  public:
    StyledText(bool colour, std::size_t width) : colour_(colour), width_(width) {}

    /// One line that is never broken.
    void line(std::string_view prefix, const Spans& spans);
    /// Lines that keep to the room; the first one after `prefix`, the others after `hanging`.
    void paragraph(std::string_view prefix, std::string_view hanging, const Spans& spans);

    /// The columns that are left after a prefix: those up to the width, but enough to say something
    /// however long the prefix is.
    std::size_t room_after(std::string_view prefix) const;
    std::string take() { return std::move(text_); }

  private:
    void put(Style style, std::string_view text);

    bool colour_;
    std::size_t width_;
    std::string text_;
};

}  // namespace raytree
