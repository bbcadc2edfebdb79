#pragma once

#include <vector>

#include "check/conventions.h"

/// The axes, in the files of what they are about. Adding a value is adding a row; the first of an
/// axis is its default.
namespace raytree::check {

const std::vector<Convention>& camera_conventions();
const std::vector<Convention>& light_conventions();
const std::vector<Convention>& tree_conventions();

}  // namespace raytree::check
