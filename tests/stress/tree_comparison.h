#pragma once

#include <ostream>

#include "stress.h"
#include "support/tree_comparison.h"

namespace raytree::stress {

/// Compares the trees of a pixel (compare_trees); `describe(out)` says which scene it is.
template <class Describe> void try_tree(const World<double>& own, const World<Quad>& reference,
                                        int i, int j, Tally& tally, Describe&& describe) {
    const test::TreeVerdict verdict = test::compare_trees(own, reference, i, j);
    Outcome& outcome = tally.in_double;
    outcome.undecided += verdict.undecided ? 1 : 0;
    outcome.wrong += verdict.wrong ? 1 : 0;
    if (!(verdict.share <= outcome.worst)) {
        outcome.worst = verdict.share;
    }
    if (verdict.wrong) {
        tally.describe<double>([&](std::ostream& out) {
            describe(out);
            out << ", pixel " << i << ',' << j << ": " << verdict.what;
        });
    }
}

}  // namespace raytree::stress
