#include "accel/wide_bvh.h"

#include <doctest/doctest.h>

#include <random>

using namespace raytree;

namespace {

/// Small boxes scattered in a cube, of two kinds.
std::vector<WideBvh::Item> scattered(std::size_t count, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(-1, 1), size(0.001, 0.05);
    std::vector<WideBvh::Item> items(count);
    for (WideBvh::Item& item : items) {
        const Vec3<double> low(place(random), place(random), place(random));
        item.box.include(low);
        item.box.include(low + Vec3<double>(size(random), size(random), size(random)));
        item.kind = random() % 4 == 0 ? 1 : 0;
    }
    return items;
}

/// Walks a hierarchy and counts what is wrong in it.
struct Walk {
    const WideBvh& bvh;
    std::span<const WideBvh::Item> items;
    std::vector<int> seen = std::vector<int>(items.size());
    std::size_t children = 0, wrong = 0;

    void node(std::size_t place) {
        const WideBvh::Node& n = bvh.nodes()[place];
        for (std::size_t k = 0; k < WideBvh::width; ++k) {
            if (!(n.min[0][k] <= n.max[0][k])) {
                continue;
            }
            ++children;
            if (n.child[k].is_leaf()) {
                leaf(n, k);
            } else {
                inner(n, k);
                node(n.child[k].node());
            }
        }
    }
    void inner(const WideBvh::Node& n, std::size_t k) {
        const WideBvh::Node& below = bvh.nodes()[n.child[k].node()];
        for (std::size_t c = 0; c < WideBvh::width; ++c) {
            for (std::size_t axis = 0; below.min[0][c] <= below.max[0][c] && axis < 3; ++axis) {
                wrong += below.min[axis][c] < n.min[axis][k] ? 1 : 0;
                wrong += below.max[axis][c] > n.max[axis][k] ? 1 : 0;
            }
        }
    }
    void leaf(const WideBvh::Node& n, std::size_t k) {
        const WideBvh::Ref ref = n.child[k];
        for (const std::uint32_t item : bvh.items().subspan(ref.first(), ref.count())) {
            ++seen[item];
            wrong += items[item].kind != ref.kind() ? 1 : 0;
            for (int axis = 0; axis < 3; ++axis) {
                const auto a = static_cast<std::size_t>(axis);
                const auto here = [&](double x) { return (x - bvh.center()[axis]) * bvh.scale(); };
                wrong += here(items[item].box.min[axis]) < static_cast<double>(n.min[a][k]);
                wrong += here(items[item].box.max[axis]) > static_cast<double>(n.max[a][k]);
            }
        }
    }
};

}  // namespace

TEST_CASE("wide hierarchy: every item lies in one leaf of its kind, inside all boxes above it") {
    WideBvh::Config config;
    for (const std::uint8_t leaf : {1, 3, 8}) {
        config.leaf_items = {leaf, leaf, leaf, leaf};
        for (const std::size_t count : {1U, 2U, 9U, 100U, 3000U}) {
            const auto items = scattered(count, 3);
            const WideBvh bvh(items, config);
            Walk walk{bvh, items};
            walk.node(0);
            CAPTURE(count);
            CHECK(walk.wrong == 0);
            CHECK(std::ranges::count(walk.seen, 1) == static_cast<std::ptrdiff_t>(count));
        }
    }
}

TEST_CASE("wide hierarchy: nodes are well filled") {
    // Eight children at most; giving the places to whatever is widest left half of them empty.
    const auto items = scattered(20'000, 5);
    for (const std::uint8_t leaf : {1, 8}) {
        WideBvh::Config config;
        config.leaf_items = {leaf, leaf, leaf, leaf};
        const WideBvh bvh(items, config);
        Walk walk{bvh, items};
        walk.node(0);
        CHECK(static_cast<double>(walk.children) > 5.0 * static_cast<double>(bvh.node_count()));
    }
}
