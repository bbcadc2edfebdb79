#pragma once

#include <string>

#include "tree/ray_tree.h"

/// A pixel's ray tree to be filled in by hand: its rays and who sends whom, without a number.
namespace raytree {

/// As raytree/1.0: the kind, the place and the light of each ray, and `null` for every number. What
/// says by being there or not (`blocked_by`, `hit: null`, `termination`, `skipped`) is left out; a
/// ray that hits has a `hit` to fill in.
std::string write_tree_template_json(const RayTree<double>& tree);

/// As an outline to print, with lines to write on.
std::string write_tree_template_text(const RayTree<double>& tree);

}  // namespace raytree
