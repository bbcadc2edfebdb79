#pragma once

#include <string>
#include <string_view>

namespace raytree {

/// `text` for XML 1.0: the five special characters escaped, what XML cannot hold replaced.
std::string xml_text(std::string_view text);

}  // namespace raytree
