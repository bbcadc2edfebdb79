#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

#include "accel/wide_bvh.h"

namespace raytree {
namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

/// Three coordinates and one more lane, whatever it holds, in one register of any processor.
using Lanes = float __attribute__((vector_size(16)));

float round_down(double x) {
    const auto f = static_cast<float>(x);
    return static_cast<double>(f) > x ? std::nextafter(f, -infinite) : f;
}

float round_up(double x) { return -round_down(-x); }

/// A box in the coordinates of the hierarchy.
struct FloatBox {
    Lanes min = {infinite, infinite, infinite, infinite};
    Lanes max = {-infinite, -infinite, -infinite, -infinite};

    void include(const FloatBox& box) {
        min = box.min < min ? box.min : min;
        max = box.max > max ? box.max : max;
    }
    float half_area() const {
        const Lanes s = max - min;
        return s[0] * s[1] + s[1] * s[2] + s[2] * s[0];
    }
};

/// An item while the hierarchy is built; its place in the list, and its kind.
struct Reference {
    FloatBox box;
    std::uint32_t item;
    std::uint32_t kind;

    Lanes twice_center() const { return box.min + box.max; }
};

}  // namespace

/// Builds a binary hierarchy top down by the binned surface-area heuristic (Wald, "On fast
/// construction of SAH-based bounding volume hierarchies", 2007), then gives each node the eight
/// descendants of largest area as children.
class WideBvhBuilder {
  public:
    WideBvhBuilder(WideBvh& bvh, std::span<const WideBvh::Item> items,
                   const WideBvh::Config& config)
        : bvh_(bvh),
          config_(config),
          count_(items.size()),
          references_(std::make_unique_for_overwrite<Reference[]>(items.size())),
          binary_(std::make_unique_for_overwrite<BinaryNode[]>(2 * items.size())) {
        for (std::size_t k = 0; k < WideBvh::kinds; ++k) {
            reciprocal_[k] = ((std::uint64_t(1) << 32) - 1) / config.leaf_items[k] + 1;
        }
        place_in_unit_space(items);
    }

    void build() {
        split(used_++, 0, count_, 0);
        bvh_.items_.resize(count_);
        for (std::size_t k = 0; k < count_; ++k) {
            bvh_.items_[k] = references_[k].item;
        }
        bvh_.nodes_.reserve(used_ / 8 + 1);
        collapse(0);
    }

  private:
    struct BinaryNode {
        FloatBox box;
        std::uint32_t first;  ///< of two neighbouring children, or of the items
        std::uint32_t items;  ///< 0: not a leaf
        std::uint32_t kind;
    };
    struct Bin {
        FloatBox box;
        std::array<std::uint32_t, WideBvh::kinds> items{};
        void include(const Bin& bin) {
            box.include(bin.box);
            for (std::size_t k = 0; k < WideBvh::kinds; ++k) {
                items[k] += bin.items[k];
            }
        }
        std::uint32_t count() const { return items[0] + items[1] + items[2] + items[3]; }
    };
    static constexpr int max_bins = 16;
    using Bins = std::array<Bin, max_bins>;
    /// Items up to a bin on one side, or where `bin` is negative those up to a doubled centre.
    struct Cut {
        int axis = -1;
        int bin = 0;
        float cost = infinite;
        float center = 0;
    };
    /// The items of a node: their boxes' union, that of their centres (doubled), how many there
    /// are of each kind.
    struct Range {
        Bin all;
        FloatBox centers;
    };

    static constexpr int deepest_heuristic_split = 40;
    static constexpr std::size_t parallel_items = 1024;
    /// So few are not put into bins: a cut may fall between any two.
    static constexpr std::size_t few_items = 8;

    void place_in_unit_space(std::span<const WideBvh::Item> items) {
        Box all;
        for (const WideBvh::Item& item : items) {
            all.include(item.box);
        }
        bvh_.center_ = all.center();
        const double extent = largest_component<double>(0.5 * all.max - 0.5 * all.min);
        int exponent = 0;
        std::frexp(extent, &exponent);
        bvh_.scale_ = extent > 0 ? std::ldexp(1.0, -std::clamp(exponent, -1000, 1000)) : 1.0;
        const Vec3<double> c = bvh_.center_;
        const double s = bvh_.scale_;
        tbb::parallel_for(
            tbb::blocked_range<std::size_t>(0, count_, parallel_items), [&](const auto& range) {
                for (std::size_t k = range.begin(); k < range.end(); ++k) {
                    const Vec3<double> low = (items[k].box.min - c) * s;
                    const Vec3<double> high = (items[k].box.max - c) * s;
                    Reference& reference = references_[k];
                    reference.box.min =
                        Lanes{round_down(low.x), round_down(low.y), round_down(low.z), 0};
                    reference.box.max =
                        Lanes{round_up(high.x), round_up(high.y), round_up(high.z), 0};
                    reference.item = static_cast<std::uint32_t>(k);
                    reference.kind = items[k].kind;
                }
            });
    }

    Range range_of(std::size_t begin, std::size_t end) const {
        Range range;
        for (std::size_t k = begin; k < end; ++k) {
            const Reference& reference = references_[k];
            range.all.box.include(reference.box);
            ++range.all.items[reference.kind];
            const Lanes center = reference.twice_center();
            range.centers.include({center, center});
        }
        return range;
    }

    void split(std::uint32_t place, std::size_t begin, std::size_t end, int depth) {
        BinaryNode& node = binary_[place];
        const Range range = range_of(begin, end);
        node.box = range.all.box;
        Cut cut;
        if (depth < deepest_heuristic_split) {
            cut = best_cut(begin, end, range.centers);
        }
        const std::uint32_t kind = references_[begin].kind;
        const bool fits =
            range.all.items[kind] == end - begin && end - begin <= config_.leaf_items[kind];
        const float area = node.box.half_area();
        if (fits && !(cut.cost + config_.cost_of_split * area < area)) {
            node.first = static_cast<std::uint32_t>(begin);
            node.items = static_cast<std::uint32_t>(end - begin);
            node.kind = kind;
            return;
        }
        const std::size_t middle = divide(begin, end, range, cut);
        const std::uint32_t children = used_.fetch_add(2);
        node.first = children;
        node.items = 0;
        const auto left = [&] { split(children, begin, middle, depth + 1); };
        const auto right = [&] { split(children + 1, middle, end, depth + 1); };
        if (end - begin > parallel_items) {
            tbb::parallel_invoke(left, right);
        } else {
            left();
            right();
        }
    }

    /// Puts the items of the cut's one side before those of the other; without a cut half of them,
    /// or those of one kind.
    std::size_t divide(std::size_t begin, std::size_t end, const Range& range, const Cut& cut) {
        Reference* const from = &references_[begin];
        Reference* const to = from + (end - begin);
        if (cut.axis >= 0 && cut.bin < 0) {
            Reference* const middle = std::partition(from, to, [&](const Reference& reference) {
                return reference.twice_center()[cut.axis] <= cut.center;
            });
            return static_cast<std::size_t>(middle - &references_[0]);
        }
        if (cut.axis >= 0) {
            const Scale scale(range.centers, config_.bins);
            Reference* const middle = std::partition(from, to, [&](const Reference& reference) {
                return scale.bin_of(reference, cut.axis) <= cut.bin;
            });
            return static_cast<std::size_t>(middle - &references_[0]);
        }
        const std::uint32_t kind = from->kind;
        Reference* const others = std::stable_partition(
            from, to, [&](const Reference& reference) { return reference.kind == kind; });
        if (others != to) {
            return static_cast<std::size_t>(others - &references_[0]);
        }
        const Lanes size = range.centers.max - range.centers.min;
        const int axis = size[0] >= size[1] && size[0] >= size[2] ? 0 : size[1] >= size[2] ? 1 : 2;
        const std::size_t middle = begin + (end - begin) / 2;
        std::nth_element(from, &references_[middle], to, [&](const auto& a, const auto& b) {
            const float ca = a.twice_center()[axis], cb = b.twice_center()[axis];
            return ca < cb || (ca == cb && a.item < b.item);
        });
        return middle;
    }

    /// Whether centres so far apart can be told into bins: closer ones, in a scene some 10^30 times
    /// as large, have no float to be multiplied with.
    static bool can_be_cut(float extent) { return extent > 1e-30F; }

    /// Which bin a centre falls into.
    struct Scale {
        Lanes low, factor;
        int bins;
        Scale(const FloatBox& centers, int count) : low(centers.min), bins(count) {
            const Lanes size = centers.max - centers.min;
            for (int axis = 0; axis < 4; ++axis) {
                factor[axis] =
                    can_be_cut(size[axis]) ? static_cast<float>(count) / size[axis] : 0.0F;
            }
        }
        int bin_of(const Reference& reference, int axis) const {
            const float place = (reference.twice_center()[axis] - low[axis]) * factor[axis];
            // The factor of centres that all but coincide is infinite.
            return place > 0 ? static_cast<int>(std::min(place, static_cast<float>(bins - 1))) : 0;
        }
    };

    Cut best_cut(std::size_t begin, std::size_t end, const FloatBox& centers) const {
        Cut best;
        if (end - begin <= few_items) {
            for (int axis = 0; axis < 3; ++axis) {
                if (can_be_cut(centers.max[axis] - centers.min[axis])) {
                    cut_few(begin, end - begin, axis, best);
                }
            }
            return best;
        }
        const Scale scale(centers, config_.bins);
        std::array<Bins, 3> bins;
        for (std::size_t k = begin; k < end; ++k) {
            const Reference& reference = references_[k];
            for (int axis = 0; axis < 3; ++axis) {
                Bin& bin = bins[static_cast<std::size_t>(axis)]
                               [static_cast<std::size_t>(scale.bin_of(reference, axis))];
                bin.box.include(reference.box);
                ++bin.items[reference.kind];
            }
        }
        for (int axis = 0; axis < 3; ++axis) {
            if (can_be_cut(centers.max[axis] - centers.min[axis])) {
                sweep(bins[static_cast<std::size_t>(axis)], axis, best);
            }
        }
        return best;
    }

    /// The best cut across an axis, between any two of a few items.
    void cut_few(std::size_t begin, std::size_t count, int axis, Cut& best) const {
        struct Placed {
            float center;
            const Reference* reference;
        };
        std::array<Placed, few_items> items;
        for (std::size_t k = 0; k < count; ++k) {
            const Reference& reference = references_[begin + k];
            const float center = reference.twice_center()[axis];
            std::size_t place = k;
            for (; place > 0 && items[place - 1].center > center; --place) {
                items[place] = items[place - 1];
            }
            items[place] = {center, &reference};
        }
        const auto add = [](Bin& side, const Placed& item) {
            side.box.include(item.reference->box);
            ++side.items[item.reference->kind];
        };
        std::array<float, few_items> right_cost{};
        Bin side;
        for (std::size_t k = count - 1; k > 0; --k) {
            add(side, items[k]);
            right_cost[k] = cost(side);
        }
        side = {};
        for (std::size_t k = 0; k + 1 < count; ++k) {
            add(side, items[k]);
            const float total = cost(side) + right_cost[k + 1];
            if (total < best.cost && items[k].center < items[k + 1].center) {
                best = {axis, -1, total, items[k].center};
            }
        }
    }

    void sweep(const Bins& bins, int axis, Cut& best) const {
        const auto count = static_cast<std::size_t>(config_.bins);
        std::array<float, max_bins> right_cost{};
        Bin side;
        for (std::size_t k = count - 1; k > 0; --k) {
            side.include(bins[k]);
            right_cost[k] = cost(side);
        }
        side = {};
        for (std::size_t k = 0; k + 1 < count; ++k) {
            side.include(bins[k]);
            const float total = cost(side) + right_cost[k + 1];
            if (total < best.cost) {
                best = {axis, static_cast<int>(k), total, 0};
            }
        }
    }

    /// Infinite for a side without items, so that no cut leaves one empty.
    float cost(const Bin& side) const {
        if (side.count() == 0) {
            return infinite;
        }
        std::uint32_t leaves = 0;
        for (std::size_t k = 0; k < WideBvh::kinds; ++k) {
            leaves += leaves_of(side.items[k], k);
        }
        return side.box.half_area() * static_cast<float>(leaves);
    }

    /// How many leaves so many items of a kind fill: divided by a product, exact below 2^29.
    std::uint32_t leaves_of(std::uint32_t items, std::size_t kind) const {
        return static_cast<std::uint32_t>(
            (items + config_.leaf_items[kind] - 1) * reciprocal_[kind] >> 32);
    }

    std::uint32_t collapse(std::uint32_t root) {
        std::array<std::uint32_t, WideBvh::width> children{root};
        std::size_t count = 1;
        while (count < WideBvh::width) {
            const std::size_t widest = widest_inner(children, count);
            if (widest == count) {
                break;
            }
            const std::uint32_t first = binary_[children[widest]].first;
            children[widest] = first;
            children[count++] = first + 1;
        }
        const auto place = static_cast<std::uint32_t>(bvh_.nodes_.size());
        bvh_.nodes_.emplace_back();
        for (std::size_t k = 0; k < WideBvh::width; ++k) {
            fill_child(place, k, k < count ? &binary_[children[k]] : nullptr);
            if (k < count && binary_[children[k]].items == 0) {
                const std::uint32_t child = collapse(children[k]);
                bvh_.nodes_[place].child[k] = WideBvh::Ref::to_node(child);
            }
        }
        order_children(bvh_.nodes_[place], count);
        return place;
    }

    std::size_t widest_inner(const std::array<std::uint32_t, WideBvh::width>& children,
                             std::size_t count) const {
        std::size_t widest = count;
        float area = -1;
        for (std::size_t k = 0; k < count; ++k) {
            const BinaryNode& node = binary_[children[k]];
            if (node.items == 0 && node.box.half_area() > area) {
                area = node.box.half_area();
                widest = k;
            }
        }
        return widest;
    }

    void fill_child(std::uint32_t place, std::size_t k, const BinaryNode* from) {
        WideBvh::Node& node = bvh_.nodes_[place];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            node.min[axis][k] = from ? from->box.min[axis] : infinite;
            node.max[axis][k] = from ? from->box.max[axis] : -infinite;
        }
        if (from && from->items > 0) {
            node.child[k] = WideBvh::Ref::to_leaf(from->first, from->items, from->kind);
        }
    }

    static void order_children(WideBvh::Node& node, std::size_t count) {
        node.order.fill(0);
        for (unsigned octant = 0; octant < 8; ++octant) {
            std::array<float, WideBvh::width> depth{};
            std::array<std::uint32_t, WideBvh::width> order{};
            for (std::size_t k = 0; k < WideBvh::width; ++k) {
                order[k] = static_cast<std::uint32_t>(k);
                for (std::size_t axis = 0; k < count && axis < 3; ++axis) {
                    const float center = node.min[axis][k] + node.max[axis][k];
                    depth[k] += (octant >> axis & 1) != 0 ? -center : center;
                }
            }
            std::stable_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count),
                             [&](auto a, auto b) { return depth[a] > depth[b]; });
            for (std::size_t k = 0; k < WideBvh::width; ++k) {
                node.order[k] |= order[k] << 3 * octant;
            }
        }
    }

    WideBvh& bvh_;
    WideBvh::Config config_;
    std::size_t count_;
    std::unique_ptr<Reference[]> references_;
    std::unique_ptr<BinaryNode[]> binary_;
    std::atomic<std::uint32_t> used_{0};
    std::array<std::uint64_t, WideBvh::kinds>
        reciprocal_;  ///< of leaf_items, times 2^32, rounded up
};

WideBvh::WideBvh(std::span<const Item> items, const Config& config,
                 std::span<const std::uint32_t> names) {
    if (items.size() > most_items) {
        throw std::length_error("a hierarchy holds at most " + std::to_string(most_items) +
                                " shapes, not " + std::to_string(items.size()));
    }
    if (!items.empty()) {
        WideBvhBuilder(*this, items, config).build();
    }
    for (std::uint32_t& item : items_) {
        item = names.empty() ? item : names[item];
    }
}

}  // namespace raytree
