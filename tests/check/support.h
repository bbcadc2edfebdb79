#pragma once

#include <string>

#include "check/check.h"
#include "tree/ray_tree.h"

namespace raytree::test {

/// The JSON text with every number outside strings rounded to `digits` significant digits.
std::string with_digits(const std::string& json, int digits);

/// The scene of that name in data/scenes.
Scene data_scene(const std::string& name);

/// What the checker says of a tree once it has been written and read.
check::Report check_tree(const check::Checker& checker, const RayTree<double>& tree);

/// The findings in words, for messages.
std::string in_words(const check::Report& report);

}  // namespace raytree::test
