#pragma once

#include <string>

#include "state/state.h"

/// The selected ray for the clipboard; there must be a tree.
namespace raytree::inspector {

/// What the details say of it, line by line, every digit of its numbers.
std::string ray_as_text(const State& state);
/// As it stands in raytree/1.0.
std::string ray_as_json(const State& state);

}  // namespace raytree::inspector
