#pragma once

#include <array>
#include <vector>

#include "state/document.h"

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
    /// most 1, they add at most the sum of their weights to the pixel.
    struct Lost {
        std::size_t branches = 0;
        Rgb<double> weight{0};
    };

    std::array<Kind, 4> kinds;
    std::vector<NotSent> not_sent;  ///< those that occur, the most frequent first
    Lost to_depth, to_weight;
    std::size_t tests = 0;  ///< of a ray with a shape
    double all_tests = 0;   ///< of every ray with every shape
    std::size_t shapes = 0;
};

TreeStatistics statistics_of(const Document& document, const RayTree<double>& tree);

}  // namespace raytree::inspector
