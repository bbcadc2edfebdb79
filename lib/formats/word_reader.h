#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "math/rgb.h"
#include "math/vector.h"
#include "scene/input_error.h"

namespace raytree {

/// A word of a text file and where it stands, for messages.
struct Word {
    std::string_view text;
    std::size_t line = 0;    ///< from 1
    std::size_t column = 0;  ///< from 1, in bytes
};

/// Splits a text into words between blanks, by lines. A `#` begins a comment where the format has
/// them. Refers to the text, which must outlive it.
class WordReader {
  public:
    enum class Comments { none, hash };

    WordReader(std::string_view text, std::string file, Comments comments)
        : text_(text), file_(std::move(file)), comments_(comments) {
        skip_blanks();
    }

    bool at_end() const { return position_ == text_.size(); }
    /// Bytes that have been read, of so many.
    std::size_t position() const { return position_; }
    std::size_t size() const { return text_.size(); }
    /// The next word, which is left to be read; an empty text at the end of the file.
    Word peek() const;
    Word next();
    /// From now on the end of that line counts as the end of the file; 0: of no line.
    void stay_on_line(std::size_t line) { only_line_ = line; }
    /// Whether the next word stands on line `line`.
    bool continues(std::size_t line) const { return !at_end() && line_ == line; }

    /// The nearest double to the next word. Anything but a finite decimal number is an error that
    /// says that `what` was expected.
    double number(std::string_view what);
    /// A whole number, at least `least` and at most `most`.
    long long whole_number(std::string_view what, long long least, long long most);
    Vec3<double> point(std::string_view what);
    Rgb<double> colour(std::string_view what);
    /// Whether the next word is a number in spelling.
    bool number_follows() const;

    /// `found "WORD"`, shortened, or that the file or line ended.
    std::string found(const Word& word) const;
    [[noreturn]] void fail(const Word& word, const std::string& text) const;
    std::string place(const Word& word) const;
    const std::string& file() const { return file_; }

  private:
    void skip_blanks();

    std::string_view text_;
    std::string file_;
    Comments comments_;
    std::size_t position_ = 0;
    std::size_t line_ = 1;
    std::size_t line_start_ = 0;
    std::size_t end_column_ = 1;  ///< after the word last read
    std::size_t only_line_ = 0;
};

/// The nearest double to all of `word`, a decimal number; tells whether it is one, and finite.
bool parse_number(std::string_view word, double& out);

}  // namespace raytree
