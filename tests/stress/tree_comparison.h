#pragma once

#include <ostream>
#include <string>

#include "stress.h"
#include "trace/world.h"

namespace raytree::stress {

/// What came of it: `share` of a bound is the largest error; over 1 is wrong, and so is a shape
/// that differs unmarked.
struct TreeVerdict {
    bool undecided = false;
    bool wrong = false;
    double share = 0;
    std::string what;
};

TreeVerdict compare_trees(const World<double>& own, const World<Quad>& reference, int i, int j);

/// Traces a pixel in double and in the reference arithmetic: the trees must have the same shape, or
/// the ray where they part, or one on its way, must be marked as undecided; every number must be
/// within its bound. `describe(out)` says which scene it is.
template <class Describe> void try_tree(const World<double>& own, const World<Quad>& reference,
                                        int i, int j, Tally& tally, Describe&& describe) {
    const TreeVerdict verdict = compare_trees(own, reference, i, j);
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
