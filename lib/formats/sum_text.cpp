#include "formats/sum_text.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "formats/styled_text.h"

namespace raytree {
namespace {

/// Cells that stand under each other: symbols, then a number for each channel.
using Column = std::vector<std::string>;

std::size_t width_of(const Column& column) {
    std::size_t width = 0;
    for (const std::string& cell : column) {
        width = std::max(width, columns_of(cell));
    }
    return width;
}

void append(Column& lines, std::string_view sign, const Column& column) {
    const std::size_t width = width_of(column);
    for (std::size_t line = 0; line < lines.size(); ++line) {
        lines[line] += std::string(sign) + padded(column[line], width);
    }
}

}  // namespace

std::vector<SumLine> sum_lines(const Rgb<double>& intensity, const std::vector<Term>& terms,
                               std::size_t room) {
    const bool grey = is_grey(intensity) && std::ranges::all_of(terms, &Term::grey);
    const std::size_t channels_shown = grey ? 1 : 3;
    Column total{"I"};
    for (std::size_t c = 0; c < channels_shown; ++c) {
        total.push_back(number_text(channels(intensity)[c]));
    }
    Column lines(total.size());
    append(lines, "", total);

    std::vector<SumLine> block;
    const auto finish_block = [&] {
        for (std::size_t line = 0; line < lines.size(); ++line) {
            const std::string label = line == 0 ? "" : grey ? "each" : channel_names[line - 1];
            block.push_back({label, std::move(lines[line])});
        }
    };
    std::string_view sign = " = ";
    for (const Term& term : terms) {
        Column column{term.symbols};
        for (std::size_t c = 0; c < channels_shown; ++c) {
            column.push_back(term.numbers[c]);
        }
        if (width_of(lines) + sign.size() + width_of(column) > room && sign == " + ") {
            finish_block();
            lines.assign(total.size(), std::string(width_of(total), ' '));
        }
        append(lines, sign, column);
        sign = " + ";
    }
    finish_block();
    return block;
}

}  // namespace raytree
