#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "check/submission.h"
#include "tree/error_bounds.h"
#include "tree/given.h"
#include "tree/ray_tree.h"

namespace raytree::inspector {

/// What a ray is beside the tree that its own is compared with.
enum class RayMark {
    none,       ///< nothing is compared
    same,       ///< its counterpart says the same
    different,  ///< it does not, and the reason lies here
    follows,    ///< it does not, because another ray does not
    missing,    ///< only in the tree compared with, which is the reference
    extra,      ///< not in the reference
    cut         ///< was there before the scene was changed
};

struct MarkText {
    std::string_view sign;       ///< "≠"
    std::string_view word;       ///< "differs"
    std::string_view explained;  ///< for legends
};
const MarkText& text_of(RayMark mark);

/// A sentence on a ray of the shown tree.
struct ContrastLine {
    std::size_t ray = 0;
    RayMark mark = RayMark::different;
    std::string text;
};

/// The shown tree beside another one.
struct Contrast {
    enum class What {
        cut,     ///< only what a change of the scene has cut off
        change,  ///< before and after a change
        pixel,   ///< of another pixel
        file     ///< one of them is as recorded in a file
    };
    What what = What::cut;
    std::string shown_name, other_name;  ///< whose the trees are
    bool shown_is_reference = false;
    RayTree<double> other;
    std::shared_ptr<const check::Submission> other_recorded;  ///< null: it was traced here
    std::vector<std::optional<std::size_t>> counterparts;     ///< of the shown rays, in `other`
    std::vector<RayMark> marks;                               ///< of the shown rays
    std::vector<ContrastLine> lines;                          ///< first causes first
    std::vector<std::string> remarks;  ///< what holds for the whole: the likeliest mistakes
};

/// The tree of the chosen pixel and its rays' children. Rays that only the tree has that it is
/// compared with stand at the end, each among the children of the ray that would have sent it.
struct PixelTree {
    RayTree<double> tree;
    std::vector<std::vector<std::size_t>> children;
    std::size_t grafted = 0;                             ///< rays at the end that are not its own
    std::shared_ptr<const Contrast> contrast = nullptr;  ///< null: it is not compared
    /// The file's data, where the tree is shown as somebody else recorded it.
    std::shared_ptr<const check::Submission> recorded = nullptr;

    /// Of its own rays; null where they have not been asked for.
    std::shared_ptr<const std::vector<RayBounds>> bounds = nullptr;
    std::vector<std::shared_ptr<const PixelTree>> neighbours = {};  ///< those that are shown

    std::size_t own() const { return tree.rays.size() - grafted; }
    bool is_own(std::size_t ray) const { return ray < own(); }
    /// Whether a number of a ray is known: a tree that was recorded elsewhere may lack it.
    bool gives(std::size_t ray, Field field) const;
    /// Of what comes back along it; of a shadow ray, what it adds.
    bool gives_intensity(std::size_t ray) const;
    RayMark mark(std::size_t ray) const { return contrast ? contrast->marks[ray] : RayMark::none; }
};

/// The tree without the rays of others.
RayTree<double> own_tree(const PixelTree& tree);

/// "#3"; of a ray that only the other tree has, its number there: "(#3)".
std::string number_of(const PixelTree& tree, std::size_t ray);
/// The same while the contrast is still being made.
std::string number_of(const PixelTree& tree, const Contrast& contrast, std::size_t ray);

/// "≠ differs"; empty where there is nothing to say.
std::string mark_text(RayMark mark);

}  // namespace raytree::inspector
