#include "lesson/text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>

#include "trace/reason.h"

namespace raytree::lesson {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
/// Whether the text ends in a letter, Latin or Greek, so that a digit after it belongs to a name.
bool ends_in_letter(std::string_view text) {
    const auto byte = [&](std::size_t back) {
        return static_cast<unsigned char>(text[text.size() - back]);
    };
    const bool greek = text.size() >= 2 && (byte(2) == 0xCE || byte(2) == 0xCF);
    return greek || (!text.empty() && std::isalpha(byte(1)) != 0);
}

/// Small numbers belong to formulas themselves: B² − 4 A C, 2 tan θ, i + 0.5.
bool belongs_to_formulas(std::string_view number) {
    static constexpr std::array<std::string_view, 9> allowed = {"0", "0.5", "1",   "2",  "3",
                                                                "4", "90",  "180", "360"};
    return std::ranges::find(allowed, number) != allowed.end();
}

/// The first number in `text` that should be a reference; digits of a name ("x1") are none.
std::string typed_number(std::string_view text, bool formula) {
    for (std::size_t k = 0; k < text.size(); ++k) {
        if (!is_digit(text[k])) {
            continue;
        }
        std::size_t end = k;
        while (end < text.size() &&
               (is_digit(text[end]) ||
                (text[end] == '.' && end + 1 < text.size() && is_digit(text[end + 1])))) {
            ++end;
        }
        const std::string_view number = text.substr(k, end - k);
        // Part of a name, as in x1 or 3D.
        const bool in_word =
            ends_in_letter(text.substr(0, k)) || (end < text.size() && text[end] == 'D');
        if (!in_word && !(formula && belongs_to_formulas(number))) {
            return std::string(number);
        }
        k = end;
    }
    return "";
}

/// Reads one text; where something is wrong it says so once and goes on.
class TextReader {
  public:
    TextReader(std::string_view source, const JsonPlace& place, JsonReport& report)
        : source_(source), place_(place), report_(report) {}

    Text read() {
        Text text;
        text.place = place_.pointer();
        for (std::size_t from = 0; from < source_.size();) {
            const std::size_t end = end_of_block(from);
            add_block(source_.substr(from, end - from), text);
            from = end;
            while (from < source_.size() && source_[from] == '\n') {
                ++from;
            }
        }
        return text;
    }

  private:
    /// A block ends at an empty line, and an item also at the next item.
    std::size_t end_of_block(std::size_t from) const {
        const std::size_t empty = source_.find("\n\n", from);
        const std::size_t item = source_.find("\n- ", from);
        return std::min({empty, item, source_.size()});
    }

    void add_block(std::string_view source, Text& text) {
        Block block;
        if (source.starts_with("- ")) {
            block.kind = Block::Kind::item;
            source.remove_prefix(2);
        }
        std::string line(source);
        std::ranges::replace(line, '\n', ' ');
        add_pieces(line, block);
        const bool all_formula =
            !block.pieces.empty() && std::ranges::all_of(block.pieces, [](const Piece& piece) {
                return piece.emphasis == Emphasis::formula;
            });
        if (all_formula && block.kind == Block::Kind::paragraph) {
            block.kind = Block::Kind::formula;
        }
        if (!block.pieces.empty()) {
            text.blocks.push_back(std::move(block));
        }
    }

    void add_pieces(std::string_view line, Block& block) {
        Emphasis emphasis = Emphasis::plain;
        Emphasis around_formula = Emphasis::plain;
        std::string run;
        const auto end_run = [&] {
            if (!run.empty()) {
                expect_no_number(run, emphasis);
                block.pieces.push_back({emphasis, run, std::nullopt});
                run.clear();
            }
        };
        const auto toggle = [&](Emphasis mark) {
            end_run();
            emphasis = emphasis == mark ? Emphasis::plain : mark;
        };
        for (std::size_t k = 0; k < line.size(); ++k) {
            const bool formula = emphasis == Emphasis::formula;
            if (line[k] == '{') {
                end_run();
                const std::size_t end = line.find('}', k);
                if (end == std::string_view::npos) {
                    report_.add(place_, "a reference has no end: '" + std::string(line.substr(k)) +
                                            "' lacks its }");
                    return;
                }
                add_reference(line.substr(k + 1, end - k - 1), emphasis, block);
                k = end;
            } else if (line[k] == '`') {
                end_run();
                around_formula = formula ? around_formula : emphasis;
                emphasis = formula ? around_formula : Emphasis::formula;
            } else if (!formula && line.substr(k).starts_with("**")) {
                toggle(Emphasis::strong);
                ++k;
            } else if (!formula && line[k] == '*') {
                toggle(Emphasis::stressed);
            } else {
                run += line[k];
            }
        }
        end_run();
        if (emphasis != Emphasis::plain) {
            report_.add(place_, "a mark (`, * or **) has no end in '" + std::string(line) + "'");
        }
    }

    void expect_no_number(const std::string& run, Emphasis emphasis) {
        const std::string number = typed_number(run, emphasis == Emphasis::formula);
        if (!number.empty()) {
            report_.add(place_, "the number " + number + " in '" + run +
                                    "' is typed by hand; it must be a reference, such as "
                                    "{primary.hit.t}, or a word");
        }
    }

    void add_reference(std::string_view inside, Emphasis emphasis, Block& block) {
        Reference reference;
        const std::size_t semicolon = inside.find(';');
        if (semicolon != std::string_view::npos) {
            read_form(inside.substr(semicolon + 1), reference);
        }
        try {
            reference.expression = Expression(inside.substr(0, semicolon));
            if (!reference.expression.refers()) {
                report_.add(place_, "{" + std::string(inside) +
                                        "} refers to nothing: it is a number typed by hand");
            }
            block.pieces.push_back({emphasis, "", std::move(reference)});
        } catch (const ExpressionError& error) {
            report_.add(place_, error.what());
        }
    }

    void read_form(std::string_view form, Reference& reference) {
        const std::string whole(form);
        const auto trim = [&form] {
            while (!form.empty() && form.front() == ' ') {
                form.remove_prefix(1);
            }
            while (!form.empty() && form.back() == ' ') {
                form.remove_suffix(1);
            }
        };
        trim();
        if (form.ends_with('%')) {
            reference.percent = true;
            form.remove_suffix(1);
            trim();
        }
        if (form.size() == 1 && is_digit(form[0])) {
            reference.decimals = form[0] - '0';
        } else {
            report_.add(place_, "found '" + whole +
                                    "' after the semicolon of a reference, must be a number of "
                                    "decimals from 0 to 9, with % for a percentage");
        }
    }

    std::string_view source_;
    const JsonPlace& place_;
    JsonReport& report_;
};

std::string with_decimals(double value, int decimals) {
    std::array<char, 400> digits;
    const double rounded = value == 0 ? 0.0 : value;
    std::snprintf(digits.data(), digits.size(), "%.*f", decimals, rounded);
    std::string text = digits.data();
    if (text.starts_with('-') && text.find_first_not_of("-0.") == std::string::npos) {
        text.erase(0, 1);
    }
    // Long whole parts in groups of three.
    const std::size_t point = std::min(text.find('.'), text.size());
    const std::size_t first = text.starts_with('-') ? 1 : 0;
    if (point - first > 4) {
        for (std::size_t k = point - 3; k > first; k = k > 3 ? k - 3 : 0) {
            text.insert(k, ",");
        }
    }
    return text;
}

}  // namespace

Text read_text(std::string_view source, const JsonPlace& place, JsonReport& report) {
    return TextReader(source, place, report).read();
}

std::string written(const Json& value, const Reference& reference) {
    if (value.is_number() && reference.decimals) {
        const double number = value.get<double>() * (reference.percent ? 100 : 1);
        return with_decimals(number, *reference.decimals) + (reference.percent ? " %" : "");
    }
    if (value.is_array() && reference.decimals) {
        std::string text;
        for (const Json& element : value) {
            text += (text.empty() ? "(" : ", ") + written(element, reference);
        }
        return text + ")";
    }
    std::string text = value_text(value);
    if (value.is_string() && reason_from(text)) {
        std::ranges::replace(text, '_', ' ');
    }
    return text;
}

FilledText fill(const Text& text, const Scope& scope) {
    FilledText filled;
    for (const Block& block : text.blocks) {
        FilledBlock& to = filled.emplace_back();
        to.kind = block.kind;
        for (const Piece& piece : block.pieces) {
            const std::string shown =
                piece.reference ? written(piece.reference->expression.data(scope), *piece.reference)
                                : piece.text;
            to.pieces.push_back({piece.emphasis, shown, piece.reference.has_value()});
        }
    }
    return filled;
}

std::string plain_text(const FilledText& text) {
    std::string plain;
    for (const FilledBlock& block : text) {
        plain += plain.empty() ? "" : " ";
        for (const FilledPiece& piece : block.pieces) {
            plain += piece.text;
        }
    }
    return plain;
}

}  // namespace raytree::lesson
