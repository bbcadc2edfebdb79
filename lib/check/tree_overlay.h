#pragma once

#include <string>

#include "check/check.h"

namespace raytree::check {

/// The submission's tree and the true one drawn over each other, an SVG document: a card for each
/// ray of either, marked by shape, word and colour as right, different, following from what is
/// different, missing or too many, with both values of what differs; shadow rays in the cards of
/// their hits. Of a large tree the first rays, which is said.
std::string write_tree_overlay(const Submission& submission, const RayTree<double>& truth,
                               const Report& report);

}  // namespace raytree::check
