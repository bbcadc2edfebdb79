#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace raytree {

/// Number of bytes, 1 to 4, of the well-formed UTF-8 character at the front of `text`; 0 if there
/// is none (table 3-7 of the Unicode standard: no overlong forms, no surrogates, nothing over
/// U+10FFFF).
std::size_t utf8_length(std::string_view text);

/// `text` as one line that any terminal can show: U+FFFD stands for each control character, for
/// each that hides or turns the text around it, and for each byte that is no UTF-8, so that what a
/// file says can neither garble a message nor steer the terminal.
std::string legible(std::string_view text);

}  // namespace raytree
