#pragma once

#include <memory>
#include <optional>
#include <stop_token>
#include <string>

#include "state/contrast.h"
#include "state/knobs.h"

/// What tree is to be shown, and what it is to be laid over: asked by the state, answered beside
/// it.
namespace raytree::inspector {

/// What trees are compared with.
struct Against {
    Contrast::What what = Contrast::What::pixel;
    Pixel pixel;  ///< the other's; of files, both trees' pixel
    /// Of files: null where it is the traced tree.
    std::shared_ptr<const check::Submission> reference, subject;
    bool swapped = false;
};

struct TreeQuestion {
    std::shared_ptr<const Document> document;
    std::optional<Values> values;  ///< that the scene is to have first; none: those it has
    Pixel pixel;
    bool bounds = false;  ///< whether the numbers' error bounds are asked for
    Neighbours neighbours = Neighbours::none;
    std::shared_ptr<const Document> before;  ///< null: nothing has been changed
    std::optional<Against> against;
};

struct TracedPixel {
    std::shared_ptr<const Document> document;  ///< with the values asked for
    std::shared_ptr<const PixelTree> tree;     ///< null where it has no finite intensity
    std::string failure;                       ///< why
};

/// Throws Stopped.
TracedPixel answer(const TreeQuestion& question, const std::stop_token& stop);

/// The name of a recorded tree's file.
std::string name_of(const check::Submission& recorded);

}  // namespace raytree::inspector
