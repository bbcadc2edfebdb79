#pragma once

#include <string>

#include "tree/error_bounds.h"
#include "tree/ray_tree.h"

namespace raytree {

struct OutlineOptions {
    bool colour = false;  ///< with the colours of a terminal (ECMA-48); no meaning is theirs alone
    int width = 100;      ///< columns to stay within, where names and depth allow
    const std::vector<RayBounds>* bounds = nullptr;  ///< of the numbers' errors, by ray: to be told
};

/// The tree as an outline for people: each ray with its hit, its share of the pixel, how its
/// intensity is put together, in symbols and numbers, and why it ended; the rays that were not sent
/// stand where they would have. UTF-8, ending in a line feed.
std::string write_tree_text(const RayTree<double>& tree, const OutlineOptions& options = {});

}  // namespace raytree
