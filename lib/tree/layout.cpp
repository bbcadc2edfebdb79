#include "tree/layout.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace raytree {
namespace {

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

/// A node under way, with the names of the paper. Places of a subtree are relative to its root
/// until `mod` has been summed down to them.
struct Node {
    std::vector<std::size_t> children;
    std::size_t parent = none;
    std::size_t number = 0;  ///< among its siblings
    std::size_t level = 0;
    std::size_t thread = none;    ///< the next node of a contour that leaves the subtree
    std::size_t ancestor = none;  ///< where to look for the subtree that it belongs to
    std::size_t default_ancestor = none;
    double breadth = 0;
    double prelim = 0, mod = 0, shift = 0, change = 0;
};

/// The four contours that meet between a subtree and those left of it: where each stands, and the
/// sum of `mod` above it.
struct Contour {
    std::size_t node;
    double sum;
};

class Walker {
  public:
    Walker(std::span<const LayoutNode> boxes, double gap) : nodes_(boxes.size() + 1), gap_(gap) {
        // The roots hang from one more node, so that a forest is a tree.
        super_ = boxes.size();
        nodes_[super_].ancestor = super_;
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            assert(!boxes[i].parent || *boxes[i].parent < i);
            const std::size_t parent = boxes[i].parent.value_or(super_);
            Node& node = nodes_[i];
            node.parent = parent;
            node.number = nodes_[parent].children.size();
            node.level = parent == super_ ? 0 : nodes_[parent].level + 1;
            node.ancestor = i;
            node.breadth = boxes[i].breadth;
            nodes_[parent].children.push_back(i);
        }
    }

    void walk() {
        for (const std::size_t v : post_order()) {
            first_walk(v);
            if (v != super_) {
                apportion(v);
            }
        }
        sum_up();
    }

    double middle(std::size_t v) const { return nodes_[v].prelim; }
    std::size_t level(std::size_t v) const { return nodes_[v].level; }

  private:
    std::vector<std::size_t> post_order() const {
        std::vector<std::size_t> order;
        order.reserve(nodes_.size());
        std::vector<std::size_t> stack{super_};
        while (!stack.empty()) {
            const std::size_t v = stack.back();
            stack.pop_back();
            order.push_back(v);
            stack.insert(stack.end(), nodes_[v].children.begin(), nodes_[v].children.end());
        }
        std::ranges::reverse(order);
        return order;
    }

    std::size_t left_sibling(std::size_t v) const {
        const Node& node = nodes_[v];
        return node.number == 0 ? none : nodes_[node.parent].children[node.number - 1];
    }
    std::size_t next_left(std::size_t v) const {
        return nodes_[v].children.empty() ? nodes_[v].thread : nodes_[v].children.front();
    }
    std::size_t next_right(std::size_t v) const {
        return nodes_[v].children.empty() ? nodes_[v].thread : nodes_[v].children.back();
    }
    double distance(std::size_t left, std::size_t right) const {
        return (nodes_[left].breadth + nodes_[right].breadth) / 2 + gap_;
    }

    /// Places `v` beside its left sibling and over its children.
    void first_walk(std::size_t v) {
        Node& node = nodes_[v];
        const std::size_t left = left_sibling(v);
        const double beside = left == none ? 0 : nodes_[left].prelim + distance(left, v);
        if (node.children.empty()) {
            node.prelim = beside;
            return;
        }
        execute_shifts(node);
        const double over =
            (nodes_[node.children.front()].prelim + nodes_[node.children.back()].prelim) / 2;
        node.prelim = left == none ? over : beside;
        node.mod = node.prelim - over;
    }

    /// Moves the subtree of `v` clear of the subtrees of its left siblings.
    void apportion(std::size_t v) {
        const std::size_t left = left_sibling(v);
        std::size_t& default_ancestor = nodes_[nodes_[v].parent].default_ancestor;
        if (left == none) {
            default_ancestor = v;
            return;
        }
        const std::size_t leftmost = nodes_[nodes_[v].parent].children.front();
        Contour inner_right{v, nodes_[v].mod}, outer_right = inner_right;
        Contour inner_left{left, nodes_[left].mod}, outer_left{leftmost, nodes_[leftmost].mod};
        while (next_right(inner_left.node) != none && next_left(inner_right.node) != none) {
            inner_left.node = next_right(inner_left.node);
            inner_right.node = next_left(inner_right.node);
            outer_left.node = next_left(outer_left.node);
            outer_right.node = next_right(outer_right.node);
            nodes_[outer_right.node].ancestor = v;
            const double shift = nodes_[inner_left.node].prelim + inner_left.sum -
                                 nodes_[inner_right.node].prelim - inner_right.sum +
                                 distance(inner_left.node, inner_right.node);
            if (shift > 0) {
                move_subtree(subtree_of(inner_left.node, v, default_ancestor), v, shift);
                inner_right.sum += shift;
                outer_right.sum += shift;
            }
            for (Contour* contour : {&inner_left, &inner_right, &outer_left, &outer_right}) {
                contour->sum += nodes_[contour->node].mod;
            }
        }
        if (continue_contour(outer_right, inner_left, next_right(inner_left.node),
                             next_right(outer_right.node))) {
            return;
        }
        if (continue_contour(outer_left, inner_right, next_left(inner_right.node),
                             next_left(outer_left.node))) {
            default_ancestor = v;
        }
    }

    /// Where `to` goes deeper than `from`, lets the contour of `from` go on there.
    bool continue_contour(Contour from, Contour to, std::size_t next, std::size_t own_next) {
        if (next == none || own_next != none) {
            return false;
        }
        nodes_[from.node].thread = next;
        nodes_[from.node].mod += to.sum - from.sum;
        return true;
    }

    /// The sibling of `v` whose subtree `inner` is in.
    std::size_t subtree_of(std::size_t inner, std::size_t v, std::size_t default_ancestor) const {
        const std::size_t ancestor = nodes_[inner].ancestor;
        return nodes_[ancestor].parent == nodes_[v].parent ? ancestor : default_ancestor;
    }

    /// Moves `right` by `shift`, and notes that those between it and `left` take their part.
    void move_subtree(std::size_t left, std::size_t right, double shift) {
        Node& from = nodes_[left];
        Node& to = nodes_[right];
        const double share = shift / static_cast<double>(to.number - from.number);
        to.change -= share;
        to.shift += shift;
        from.change += share;
        to.prelim += shift;
        to.mod += shift;
    }

    void execute_shifts(const Node& node) {
        double shift = 0;
        double change = 0;
        for (auto child = node.children.rbegin(); child != node.children.rend(); ++child) {
            Node& c = nodes_[*child];
            c.prelim += shift;
            c.mod += shift;
            change += c.change;
            shift += c.shift + change;
        }
    }

    /// Turns relative places into absolute ones. Parents come before their children in `nodes_`.
    void sum_up() {
        std::vector<double> above(nodes_.size(), 0);
        above[super_] = nodes_[super_].mod;
        for (std::size_t v = 0; v < super_; ++v) {
            const double sum = above[nodes_[v].parent];
            above[v] = sum + nodes_[v].mod;
            nodes_[v].prelim += sum;
        }
    }

    std::vector<Node> nodes_;
    std::size_t super_ = 0;
    double gap_;
};

}  // namespace

TreeLayout lay_out(std::span<const LayoutNode> nodes, LayoutGaps gaps) {
    TreeLayout layout;
    if (nodes.empty()) {
        return layout;
    }
    Walker walker(nodes, gaps.breadth);
    walker.walk();

    std::vector<double> level_depths;
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        level_depths.resize(std::max(level_depths.size(), walker.level(i) + 1));
        double& depth = level_depths[walker.level(i)];
        depth = std::max(depth, nodes[i].depth);
        least = std::min(least, walker.middle(i) - nodes[i].breadth / 2);
        most = std::max(most, walker.middle(i) + nodes[i].breadth / 2);
    }
    std::vector<double> starts;
    for (const double depth : level_depths) {
        starts.push_back(layout.depth);
        layout.depth += depth + gaps.depth;
    }
    layout.depth -= gaps.depth;
    layout.breadth = most - least;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        layout.places.push_back({walker.middle(i) - least, starts[walker.level(i)]});
    }
    return layout;
}

}  // namespace raytree
