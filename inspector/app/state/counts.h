#pragma once

#include <array>
#include <optional>
#include <vector>

#include "state/document.h"
#include "state/pixel_tree.h"

namespace raytree::inspector {

/// How large a pixel's tree is, and what kept it from being larger.
struct TreeStatistics {
    struct Kind {
        RayKind kind = RayKind::primary;
        std::size_t count = 0;
        double full = 0;  ///< in the full tree, (m + 1)(2^n − 1) with all kinds
    };
    struct NotSent {
        Reason reason = Reason::not_reflective;
        std::size_t count = 0;
    };
    /// Branches that a limit has cut off. With the intensity that each of them would have had, at
    /// most 1, they add at most the sum of their weights to the pixel; none where a tree is shown
    /// as a file has it, which does not say what surfaces let through.
    struct Lost {
        std::size_t branches = 0;
        std::optional<Rgb<double>> weight;
    };

    std::array<Kind, 4> kinds;
    std::vector<NotSent> not_sent;  ///< those that occur, the most frequent first
    Lost to_depth, to_weight;
    std::optional<std::size_t> tests;  ///< of a ray with a shape; none where a file lacks them
    bool tells_skipped = true;         ///< whether there is anything on rays that were not sent
    double all_tests = 0;              ///< of every ray with every shape
    std::size_t shapes = 0;
};

/// Of the tree's own rays.
TreeStatistics statistics_of(const Document& document, const PixelTree& tree);

}  // namespace raytree::inspector
