#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "scene/input_error.h"

namespace raytree {

/// A JSON document with the members of each object in the order of the text.
using Json = nlohmann::ordered_json;

/// How deep lists and objects may lie in one another in any file of ours.
inline constexpr std::size_t kDeepestJson = 64;

/// Parses strictly: RFC 8259 and nothing else (so neither NaN nor Infinity), no number too large
/// for a double, no key twice in an object, nothing nested deeper than `deepest`. Throws InputError
/// with line and column, or the JSON pointer.
Json parse_json(std::string_view text, const std::string& file, std::size_t deepest = kDeepestJson);

/// "line 3, column 7" of a byte in `text`, both from 1; columns are counted in bytes.
std::string line_and_column(std::string_view text, std::size_t offset);

}  // namespace raytree
