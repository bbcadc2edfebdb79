#pragma once

#include <memory>
#include <stop_token>

#include "state/document.h"
#include "state/neighbours.h"
#include "state/pixel_tree.h"

/// Two trees laid over each other.
namespace raytree::inspector {

/// Where a tree comes from: traced in a scene, or as a file has recorded it.
struct TreeSource {
    std::shared_ptr<const Document> document;
    Pixel pixel;
    std::shared_ptr<const check::Submission> recorded = nullptr;  ///< null: traced
    std::string name = {};                                        ///< whose it is
    bool bounds = false;  ///< whether the error bounds of a traced tree are asked for
    Neighbours neighbours = Neighbours::none;
};

/// Throws InputError where an intensity is not finite, and Stopped.
PixelTree tree_from(const TreeSource& source, const std::stop_token& stop = {});

/// How two trees are to be compared.
struct Comparison {
    TreeSource other;
    Contrast::What what = Contrast::What::cut;
    bool shown_is_reference = false;
};

/// The shown tree with the other's rays in it, marked. Where one is recorded and the other traced,
/// the recorded one is judged by `check` and every mark is its finding.
PixelTree laid_over(const TreeSource& shown, const Comparison& with,
                    const std::stop_token& stop = {});

}  // namespace raytree::inspector
