#pragma once

#include <optional>

#include "check/check.h"

namespace raytree::check {

/// The one factor by which all colours are off that are wrong in themselves, where there is one and
/// nothing else is wrong: whatever multiplies by it gives the same numbers. A colour that is left
/// out, a factor of 0, is no such thing.
std::optional<double> one_factor(const Report& report);

}  // namespace raytree::check
