#pragma once

#include <optional>

#include "state/look.h"
#include "state/pixel_tree.h"

/// How much of the diagram is folded: branches that are less than some share of the pixel. Shares
/// worth choosing are those of the tree's own rays: the heaviest are unfolded first.
namespace raytree::inspector {

/// The share of the pixel below which branches are folded: the one that is wished for or, where
/// too many boxes would be left, a larger one. Infinite: all branches are folded.
double fold_of(const PixelTree& tree, double wish);
/// The same as the pane says. Where it leaves the choice: the smallest one with which the diagram
/// is no wider than the room.
double fold_of(const PixelTree& tree, const TreePane& pane);

/// One that leaves at most about three quarters of the boxes, and one that shows about a third more
/// of them; none where nothing more can be folded or unfolded.
std::optional<double> fold_more(const PixelTree& tree, double wish);
std::optional<double> fold_less(const PixelTree& tree, double wish);

}  // namespace raytree::inspector
