#pragma once

#include <string>

#include "trace/world.h"

namespace raytree::test {

/// What came of it: `share` of a bound is the largest error; over 1 is wrong, and so is a shape
/// that differs unmarked.
struct TreeVerdict {
    bool undecided = false;
    bool wrong = false;
    double share = 0;
    std::string what;
};

/// Traces a pixel in double and in the reference arithmetic: the trees must have the same shape, or
/// the ray where they part, or one on its way, must be marked as undecided; every number must be
/// within its bound.
TreeVerdict compare_trees(const World<double>& own, const World<Quad>& reference, int i, int j);

}  // namespace raytree::test
