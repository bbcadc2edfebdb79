#include "state/folding.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <vector>

#include "formats/tree_diagram.h"

namespace raytree::inspector {
namespace {

constexpr std::size_t most_boxes = 1500;  // of rays; what a pane draws at once

/// What is left of a tree when lighter branches are folded.
struct Folded {
    double below = 0;       ///< share of the pixel
    std::size_t boxes = 0;  ///< of rays and of folded branches
};

/// Unfolds a tree from its heaviest branches on.
class Unfolding {
  public:
    explicit Unfolding(const PixelTree& tree) : tree_(tree) { unfold(0); }

    /// All that are worth choosing, from the one where all is folded to the one where nothing is,
    /// as far as there are not too many boxes.
    std::vector<Folded> steps() {
        std::vector<Folded> steps{{std::numeric_limits<double>::infinity(), boxes_}};
        while (!folded_.empty()) {
            unfold_next();
            if (boxes_ > most_boxes) {
                break;
            }
            steps.push_back({folded_.empty() ? 0 : below_, boxes_});
        }
        if (steps.size() == 1 && folded_.empty()) {
            steps.front().below = 0;  // the root is all there is
        }
        return steps;
    }

  private:
    struct Branch {
        double share;
        std::size_t ray;
        bool operator<(const Branch& other) const { return share < other.share; }
    };

    /// The heaviest branch, and those that are as heavy: they are drawn alike.
    void unfold_next() {
        constexpr double alike = 1 - 1e-9;
        below_ = std::min(below_, folded_.top().share);
        while (!folded_.empty() && folded_.top().share >= alike * below_) {
            const Branch branch = folded_.top();
            below_ = std::min(below_, branch.share);
            folded_.pop();
            unfold(branch.ray);
            if (boxes_ > most_boxes) {
                return;
            }
        }
    }

    void unfold(std::size_t ray) {
        for (const std::size_t child : tree_.children[ray]) {
            const TreeRay<double>& branch = tree_.tree.rays[child];
            if (!branch.shadow) {
                folded_.push({largest_component(branch.weight), child});
                ++boxes_;
            }
        }
    }

    const PixelTree& tree_;
    std::priority_queue<Branch> folded_;
    std::size_t boxes_ = 1;
    double below_ = std::numeric_limits<double>::infinity();
};

/// The last one that folds no less than is wished for.
std::size_t step_of(const std::vector<Folded>& steps, double wish) {
    const auto next = std::ranges::find_if(steps, [=](const Folded& s) { return s.below < wish; });
    return next == steps.begin() ? 0 : static_cast<std::size_t>(next - steps.begin()) - 1;
}

bool fits(const PixelTree& tree, const Folded& step, double room) {
    constexpr double narrowest_box = 30, highest_tree = 40;  // spares the layout of what cannot fit
    return static_cast<double>(step.boxes) * narrowest_box <= highest_tree * room &&
           diagram_of(tree.tree, step.below).width <= room;
}

}  // namespace

double fold_of(const PixelTree& tree, double wish) {
    const std::vector<Folded> steps = Unfolding(tree).steps();
    return steps[step_of(steps, wish)].below;
}

double fold_of(const PixelTree& tree, const TreePane& pane) {
    if (pane.fold_below || pane.room <= 0) {
        return fold_of(tree, pane.fold_below.value_or(0));
    }
    const std::vector<Folded> steps = Unfolding(tree).steps();
    // Nobody asks for a diagram of which nothing is left.
    std::size_t fitting = std::min<std::size_t>(1, steps.size() - 1);
    std::size_t too_wide = steps.size();
    for (std::size_t next = steps.size() - 1; fitting + 1 < too_wide;
         next = (fitting + too_wide) / 2) {
        (fits(tree, steps[next], pane.room) ? fitting : too_wide) = next;
    }
    return steps[fitting].below;
}

std::optional<double> fold_more(const PixelTree& tree, double wish) {
    const std::vector<Folded> steps = Unfolding(tree).steps();
    std::size_t step = step_of(steps, wish);
    const std::size_t boxes = steps[step].boxes;
    if (step == 0) {
        return std::nullopt;
    }
    do {
        --step;
    } while (step > 0 && 4 * steps[step].boxes > 3 * boxes);
    return steps[step].below;
}

std::optional<double> fold_less(const PixelTree& tree, double wish) {
    const std::vector<Folded> steps = Unfolding(tree).steps();
    std::size_t step = step_of(steps, wish);
    const std::size_t boxes = steps[step].boxes;
    if (step + 1 == steps.size()) {
        return std::nullopt;
    }
    do {
        ++step;
    } while (step + 1 < steps.size() && 3 * steps[step].boxes < 4 * boxes);
    return steps[step].below;
}

}  // namespace raytree::inspector
