#include "formats/styled_text.h"

#include <algorithm>
#include <array>

#include "scene/utf8.h"

namespace raytree {
namespace {

/// ECMA-48 renditions, in the order of Style. The colours are those of the other drawings, as near
/// as the usual palette of 256 comes, and of a lightness that reads on dark and on light ground.
constexpr std::array<std::string_view, 9> renditions = {"",
                                                        "\x1b[1m",
                                                        "\x1b[2m",
                                                        "\x1b[1m",
                                                        "\x1b[1;38;5;166m",
                                                        "\x1b[1;38;5;32m",
                                                        "\x1b[38;5;136m",
                                                        "\x1b[38;5;160m",
                                                        "\x1b[2m"};

/// Words with the blanks in front of them, each in the style that it has.
std::vector<Span> words_of(const Spans& spans) {
    std::vector<Span> words;
    for (const Span& span : spans) {
        std::string_view rest = span.text;
        while (!rest.empty()) {
            const std::size_t start = std::min(rest.find_first_not_of(' '), rest.size());
            const std::size_t end = std::min(rest.find(' ', start), rest.size());
            words.push_back({span.style, std::string(rest.substr(0, end))});
            rest.remove_prefix(end);
        }
    }
    return words;
}

}  // namespace

std::size_t columns_of(std::string_view text) {
    return static_cast<std::size_t>(std::ranges::count_if(
        text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string padded(std::string_view text, std::size_t columns) {
    const std::size_t used = columns_of(text);
    return std::string(text) + std::string(columns - std::min(columns, used), ' ');
}

void StyledText::put(Style style, std::string_view text) {
    const std::string_view rendition = renditions[static_cast<std::size_t>(style)];
    const bool coloured = colour_ && !rendition.empty() && !text.empty();
    text_ += coloured ? rendition : "";
    text_ += legible(text);  // a name from a file must not steer the terminal
    text_ += coloured ? "\x1b[0m" : "";
}

std::size_t StyledText::room_after(std::string_view prefix) const {
    constexpr std::size_t least = 60;
    const std::size_t used = columns_of(prefix);
    return std::max(width_, used + std::min(width_, least)) - used;
}

void StyledText::line(std::string_view prefix, const Spans& spans) {
    put(Style::label, prefix);
    for (const Span& span : spans) {
        put(span.style, span.text);
    }
    text_.erase(text_.find_last_not_of(' ') + 1);
    text_ += '\n';
}

void StyledText::paragraph(std::string_view prefix, std::string_view hanging, const Spans& spans) {
    Spans on_line;
    std::size_t column = 0;
    std::string_view before = prefix;
    Spans words = words_of(spans);
    // A word may go on in another style, as a full stop after what is stressed does.
    const auto columns_from = [&](std::size_t k) {
        std::size_t columns = columns_of(words[k].text);
        while (++k < words.size() && !words[k].text.starts_with(' ')) {
            columns += columns_of(words[k].text);
        }
        return columns;
    };
    for (std::size_t k = 0; k < words.size(); ++k) {
        Span& word = words[k];
        if (!on_line.empty() && word.text.starts_with(' ') &&
            column + columns_from(k) > room_after(before)) {
            line(before, on_line);
            on_line.clear();
            before = hanging;
            column = 0;
            word.text.erase(0, word.text.find_first_not_of(' '));
        }
        column += columns_of(word.text);
        if (!on_line.empty() && on_line.back().style == word.style) {
            on_line.back().text += word.text;
        } else {
            on_line.push_back(std::move(word));
        }
    }
    line(before, on_line);
}

}  // namespace raytree
