#pragma once

#include <string_view>

namespace raytree::inspector {

/// Orders names as a reader does: the digits in them are compared as numbers, sphere2 before
/// sphere10.
struct NaturalOrder {
    bool operator()(std::string_view a, std::string_view b) const;
};

}  // namespace raytree::inspector
