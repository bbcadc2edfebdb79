#pragma once

#include <string>
#include <vector>

#include "accuracy/errors.h"

namespace raytree::bench {

/// One way to make the picture: what it takes and how far it is off.
struct WorkPoint {
    std::string family, label;
    double seconds = 0, low = 0, high = 0;  ///< for each pixel
    Errors intensity{};                     ///< over pixels and channels
    double other_shape = NAN;               ///< pixels whose tree has another shape
    bool on_front = false;
};

/// Marks what nothing else is faster and better than; times within 5 % or within the spread between
/// quartiles count as the same.
void mark_front(std::vector<WorkPoint>& points);

/// Says of the default settings that they are on the front, or what is better and why.
std::string verdict_on_default(const std::vector<WorkPoint>& points);

}  // namespace raytree::bench
