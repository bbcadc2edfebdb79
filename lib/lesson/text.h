#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "formats/json_reader.h"
#include "lesson/expression.h"

/// The texts of a lesson: a small Markdown whose numbers are references.
///
/// Paragraphs are divided by empty lines; a line that begins with "- " is an item of a list; a
/// paragraph that is one formula stands on a line of its own. `**strong**`, `*stressed*`,
/// `` `formula` ``. `{expression}` is replaced by its value, `{expression; 2}` with two digits
/// after the point, `{expression; 1 %}` as a percentage.
namespace raytree::lesson {

enum class Emphasis { plain, strong, stressed, formula };

/// A number, or another value, looked up when the text is shown.
struct Reference {
    Expression expression;
    std::optional<int> decimals;  ///< none: four significant digits
    bool percent = false;
};

struct Piece {
    Emphasis emphasis = Emphasis::plain;
    std::string text;  ///< where it is no reference
    std::optional<Reference> reference;
};

struct Block {
    enum class Kind { paragraph, item, formula };
    Kind kind = Kind::paragraph;
    std::vector<Piece> pieces;
};

struct Text {
    std::vector<Block> blocks;
    std::string place;  ///< where it stands in its file, a JSON pointer

    bool empty() const { return blocks.empty(); }
};

/// A text with its references looked up.
struct FilledPiece {
    Emphasis emphasis = Emphasis::plain;
    std::string text;
    bool looked_up = false;
};
struct FilledBlock {
    Block::Kind kind = Block::Kind::paragraph;
    std::vector<FilledPiece> pieces;
};
using FilledText = std::vector<FilledBlock>;

/// Reads a text and reports what is wrong with it: marks without an end, expressions that are none,
/// and numbers typed by hand where a reference belongs.
Text read_text(std::string_view source, const JsonPlace& place, JsonReport& report);

/// Throws ExpressionError.
FilledText fill(const Text& text, const Scope& scope);
/// The same without emphasis, blocks divided by a blank.
std::string plain_text(const FilledText& text);

/// A value as `reference` wants it written.
std::string written(const Json& value, const Reference& reference);

}  // namespace raytree::lesson
