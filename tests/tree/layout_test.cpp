#include "tree/layout.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace raytree;

namespace {

using doctest::Approx;

LayoutNode root(double breadth = 1) { return {std::nullopt, breadth, 1}; }
LayoutNode under(std::size_t parent, double breadth = 1) { return {parent, breadth, 1}; }

std::vector<LayoutNode> random_tree(std::size_t count, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> breadth(0, 3);
    std::vector<LayoutNode> nodes{root()};
    while (nodes.size() < count) {
        // Parents among the last few make trees that are deep and bushy at once.
        const std::size_t reach = std::min<std::size_t>(nodes.size(), 12);
        nodes.push_back(under(nodes.size() - 1 - random() % reach, breadth(random)));
    }
    return nodes;
}

std::vector<std::size_t> levels_of(const std::vector<LayoutNode>& nodes) {
    std::vector<std::size_t> levels;
    for (const LayoutNode& node : nodes) {
        levels.push_back(node.parent ? levels[*node.parent] + 1 : 0);
    }
    return levels;
}

/// The nodes of each level from left to right, as the tree has them.
std::vector<std::vector<std::size_t>> rows_of(const std::vector<LayoutNode>& nodes) {
    std::vector<std::vector<std::size_t>> children(nodes.size());
    for (std::size_t k = 1; k < nodes.size(); ++k) {
        children[*nodes[k].parent].push_back(k);
    }
    std::vector<std::vector<std::size_t>> rows{{0}};
    while (!rows.back().empty()) {
        std::vector<std::size_t> next;
        for (const std::size_t node : rows.back()) {
            next.insert(next.end(), children[node].begin(), children[node].end());
        }
        rows.push_back(next);
    }
    rows.pop_back();
    return rows;
}

}  // namespace

TEST_CASE("the layout of nothing is empty") {
    const TreeLayout layout = lay_out({}, {});
    CHECK(layout.places.empty());
    CHECK(layout.breadth == 0);
    CHECK(layout.depth == 0);
}

TEST_CASE("a tree of one node is its box") {
    const std::vector<LayoutNode> nodes{{std::nullopt, 6, 4}};
    const TreeLayout layout = lay_out(nodes, {1, 1});
    CHECK(layout.places[0].middle == 3);
    CHECK(layout.places[0].start == 0);
    CHECK(layout.breadth == 6);
    CHECK(layout.depth == 4);
}

TEST_CASE("a parent stands over the middle of its children, whatever their breadth") {
    const std::vector<LayoutNode> nodes{root(), under(0, 2), under(0, 4), under(0, 2)};
    const TreeLayout layout = lay_out(nodes, {1, 10});
    CHECK(layout.places[1].middle == 1);
    CHECK(layout.places[2].middle == 5);
    CHECK(layout.places[3].middle == 9);
    CHECK(layout.places[0].middle == 5);
    CHECK(layout.breadth == 10);
    CHECK(layout.places[1].start == 11);
    CHECK(layout.depth == 12);
}

TEST_CASE("a level begins below the deepest box of the one above") {
    const std::vector<LayoutNode> nodes{root(), {0, 1, 2}, {0, 1, 7}, {1, 1, 1}};
    const TreeLayout layout = lay_out(nodes, {1, 1});
    CHECK(layout.places[1].start == 2);
    CHECK(layout.places[2].start == 2);
    CHECK(layout.places[3].start == 10);
}

TEST_CASE("a small subtree between large ones is spread evenly") {
    // Two wide subtrees and three leaves between them: the leaves divide the room.
    std::vector<LayoutNode> nodes{root(), under(0), under(0), under(0), under(0), under(0)};
    for (const std::size_t parent : {1, 5}) {
        for (int k = 0; k < 8; ++k) {
            nodes.push_back(under(parent));
        }
    }
    const TreeLayout layout = lay_out(nodes, {1, 1});
    const double step = layout.places[2].middle - layout.places[1].middle;
    for (std::size_t k = 2; k <= 5; ++k) {
        CHECK(layout.places[k].middle - layout.places[k - 1].middle == Approx(step));
    }
}

TEST_CASE("the roots of a forest stand beside each other on the first level") {
    const std::vector<LayoutNode> nodes{root(), root(), under(0), under(1)};
    const TreeLayout layout = lay_out(nodes, {1, 1});
    CHECK(layout.places[0].start == 0);
    CHECK(layout.places[1].start == 0);
    CHECK(layout.places[1].middle - layout.places[0].middle == 2);
}

TEST_CASE("in random trees no boxes overlap, order is kept and parents are centred") {
    constexpr LayoutGaps gaps{0.5, 1};
    for (unsigned seed = 1; seed <= 40; ++seed) {
        const std::vector<LayoutNode> nodes = random_tree(5 + 7 * seed, seed);
        const TreeLayout layout = lay_out(nodes, gaps);
        REQUIRE(layout.places.size() == nodes.size());
        for (const auto& row : rows_of(nodes)) {
            for (std::size_t k = 1; k < row.size(); ++k) {
                const double apart =
                    layout.places[row[k]].middle - layout.places[row[k - 1]].middle;
                const double least =
                    (nodes[row[k]].breadth + nodes[row[k - 1]].breadth) / 2 + gaps.breadth;
                CHECK(apart >= Approx(least));
            }
        }
        std::vector<std::vector<std::size_t>> children(nodes.size());
        for (std::size_t k = 1; k < nodes.size(); ++k) {
            children[*nodes[k].parent].push_back(k);
        }
        for (std::size_t k = 0; k < nodes.size(); ++k) {
            CHECK(std::isfinite(layout.places[k].middle));
            CHECK(layout.places[k].middle - nodes[k].breadth / 2 >= Approx(0));
            CHECK(layout.places[k].middle + nodes[k].breadth / 2 <= Approx(layout.breadth));
            if (!children[k].empty()) {
                const double middle = (layout.places[children[k].front()].middle +
                                       layout.places[children[k].back()].middle) /
                                      2;
                CHECK(layout.places[k].middle == Approx(middle));
            }
        }
    }
}

TEST_CASE("equal subtrees are drawn alike wherever they are") {
    std::vector<LayoutNode> nodes = random_tree(30, 7);
    const std::size_t size = nodes.size();
    std::vector<LayoutNode> twice{root()};
    for (int copy = 0; copy < 2; ++copy) {
        const std::size_t base = twice.size();
        for (const LayoutNode& node : nodes) {
            twice.push_back({node.parent ? *node.parent + base : 0, node.breadth, node.depth});
        }
    }
    const TreeLayout layout = lay_out(twice, {1, 1});
    for (std::size_t k = 1; k <= size; ++k) {
        CHECK(layout.places[k].middle - layout.places[1].middle ==
              Approx(layout.places[k + size].middle - layout.places[1 + size].middle));
    }
}

TEST_CASE("a chain of a hundred thousand nodes is a straight line") {
    std::vector<LayoutNode> nodes{root()};
    while (nodes.size() < 100000) {
        nodes.push_back(under(nodes.size() - 1));
    }
    const TreeLayout layout = lay_out(nodes, {1, 0});
    CHECK(layout.breadth == 1);
    CHECK(layout.places.back().middle == 0.5);
    CHECK(layout.places.back().start == levels_of(nodes).back());
}
