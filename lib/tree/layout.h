#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace raytree {

/// A box to be placed in a tidy drawing of a forest, in any unit of length.
struct LayoutNode {
    std::optional<std::size_t> parent;  ///< an earlier node; none for a root
    double breadth = 1;                 ///< its extent along its level, >= 0
    double depth = 1;                   ///< its extent from level to level, >= 0
};

struct LayoutGaps {
    double breadth = 1;  ///< between neighbours on a level
    double depth = 1;    ///< between levels
};

struct LayoutPlace {
    double middle = 0;  ///< of its extent along the level
    double start = 0;   ///< of its level
};

struct TreeLayout {
    std::vector<LayoutPlace> places;  ///< one for each node; the whole begins at (0, 0)
    double breadth = 0;
    double depth = 0;
};

/// Places every node so that siblings stand in their order in `nodes`, no two boxes of a level
/// overlap, a parent stands over the middle of its first and last child, and equal subtrees are
/// drawn alike. Nodes of a level begin in line. Linear in the number of nodes, and not recursive
/// (Buchheim, Jünger & Leipert, "Improving Walker's algorithm to run in linear time", 2002).
TreeLayout lay_out(std::span<const LayoutNode> nodes, LayoutGaps gaps);

}  // namespace raytree
