#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace raytree {

/// The one of `names` that `found` is probably a misspelling of, by edit distance regardless of
/// case; empty where none is near.
std::string_view probably_meant(std::string_view found, std::span<const std::string_view> names);

/// `; did you mean "NAME"?`, or nothing.
std::string did_you_mean(std::string_view found, std::span<const std::string_view> names);

}  // namespace raytree
