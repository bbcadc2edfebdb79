#include "accel/wide_bvh.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

#include "accel/surface_area_cut.h"

namespace raytree {
namespace {

constexpr float infinite = FloatBox::infinite;

float round_down(double x) {
    const auto f = static_cast<float>(x);
    return static_cast<double>(f) > x ? std::nextafter(f, -infinite) : f;
}

float round_up(double x) { return -round_down(-x); }

/// What is expected to be done below a binary node, in tests of a node or a leaf times the areas of
/// their boxes, when the node takes at most 1, 2, ... 8 of the places among some node's children.
using Costs = std::array<float, WideBvh::width>;

struct BinaryNode {
    FloatBox box;
    std::uint32_t first;  ///< of two neighbouring children, or of the items
    std::uint32_t items;  ///< 0: not a leaf
    std::uint32_t kind;
    /// At [n - 1]: how many of n places the first child is given, the second the others; 0 where
    /// all n are best not used. At [0], which cannot be shared: of the eight that are below.
    std::array<std::uint8_t, WideBvh::width> given;
    float stops;  ///< how likely a ray that enters the box is to meet something in it
    float work;   ///< tests that it is expected to need

    /// Becomes a leaf.
    Costs hold(std::size_t begin, std::span<const Reference> held) {
        first = static_cast<std::uint32_t>(begin);
        items = static_cast<std::uint32_t>(held.size());
        kind = held.front().kind;
        given.fill(0);
        float passes = 1;
        for (const Reference& reference : held) {
            passes *= 1 - part_filled * part_of(reference.box);
        }
        stops = 1 - passes;
        work = leaf_work;
        Costs costs;
        costs.fill(box.half_area());
        return costs;
    }

    /// Gives its places to its children as it costs least (Ylitie, Karras & Laine, "Efficient
    /// incoherent ray traversal on GPUs through compressed wide BVHs", HPG 2017, section 3).
    Costs share(const Costs& of_first, const Costs& of_second) {
        Costs costs;
        for (std::size_t places = 2; places <= WideBvh::width; ++places) {
            float& least = costs[places - 1];
            least = of_first[0] + of_second[places - 2];
            given[places - 1] = 1;
            for (std::size_t k = 2; k < places; ++k) {
                const float cost = of_first[k - 1] + of_second[places - k - 1];
                if (cost < least) {
                    least = cost;
                    given[places - 1] = static_cast<std::uint8_t>(k);
                }
            }
        }
        const float area = box.half_area();
        costs[0] = area + costs[WideBvh::width - 1];
        work = area > 0 ? costs[0] / area : 1;
        given[0] = given[WideBvh::width - 1];
        for (std::size_t k = 1; k < WideBvh::width; ++k) {
            if (costs[k - 1] <= costs[k]) {
                costs[k] = costs[k - 1];
                given[k] = 0;
            }
        }
        return costs;
    }

    /// Where any hit will do: how soon a ray of this box is to be stopped by work in it. What is as
    /// large as the scene comes last: it seldom lies between two points of the scene, as a room's
    /// walls never lie between its lamps and its furniture.
    float promise(float area_of_scene) const {
        const float part = area_of_scene > 0 ? box.half_area() / area_of_scene : 1;
        return stops / work * (1 - part);
    }

    float part_of(const FloatBox& other) const {
        const float area = box.half_area();
        return area > 0 ? std::min(1.0F, other.half_area() / area) : 1;
    }

  private:
    static constexpr float part_filled = 0.5F;  ///< of a shape's box, seen from anywhere
    static constexpr float leaf_work = 1.5F;    ///< beside a node's 1
};

}  // namespace

/// Builds a binary hierarchy top down, then makes nodes of eight children of it, those that are
/// expected to cost a ray least.
class WideBvhBuilder {
  public:
    WideBvhBuilder(WideBvh& bvh, std::span<const WideBvh::Item> items,
                   const WideBvh::Config& config)
        : bvh_(bvh),
          config_(config),
          cuts_(config),
          count_(items.size()),
          references_(std::make_unique_for_overwrite<Reference[]>(items.size())),
          binary_(std::make_unique_for_overwrite<BinaryNode[]>(2 * items.size())) {
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
    /// The items of a node, and the box around their doubled centres.
    struct Range {
        ItemGroup all;
        FloatBox centers;
    };
    using Children = std::array<std::uint32_t, WideBvh::width>;

    static constexpr int deepest_heuristic_split = 40;
    static constexpr std::size_t parallel_items = 1024;

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

    std::span<Reference> references(std::size_t begin, std::size_t end) const {
        return {&references_[begin], end - begin};
    }

    Range range_of(std::size_t begin, std::size_t end) const {
        Range range;
        for (const Reference& reference : references(begin, end)) {
            range.all.include(reference);
            const Lanes center = reference.twice_center();
            range.centers.include({center, center});
        }
        return range;
    }

    Costs split(std::uint32_t place, std::size_t begin, std::size_t end, int depth) {
        BinaryNode& node = binary_[place];
        const Range range = range_of(begin, end);
        node.box = range.all.box;
        Cut cut;
        if (depth < deepest_heuristic_split) {
            cut = cuts_.best(references(begin, end), range.centers);
        }
        const std::uint32_t kind = references_[begin].kind;
        const bool fits =
            range.all.items[kind] == end - begin && end - begin <= config_.leaf_items[kind];
        const float area = node.box.half_area();
        if (fits && !(cut.cost + config_.cost_of_split * area < area)) {
            return node.hold(begin, references(begin, end));
        }
        const std::size_t middle =
            cut.axis >= 0 ? begin + cuts_.divide(references(begin, end), range.centers, cut)
                          : halve(begin, end, range);
        const std::uint32_t children = used_.fetch_add(2);
        Costs of_first, of_second;
        const auto first = [&] { of_first = split(children, begin, middle, depth + 1); };
        const auto second = [&] { of_second = split(children + 1, middle, end, depth + 1); };
        if (end - begin > parallel_items) {
            tbb::parallel_invoke(first, second);
        } else {
            first();
            second();
        }
        node.first = children;
        node.items = 0;
        const Costs costs = node.share(of_first, of_second);
        if (fits && area <= costs[0]) {
            return node.hold(begin, references(begin, end));
        }
        float passes = 1;
        for (std::uint32_t k = children; k < children + 2; ++k) {
            passes *= 1 - binary_[k].stops * node.part_of(binary_[k].box);
        }
        node.stops = 1 - passes;
        return costs;
    }

    /// Where there is no cut: half of the items before the others, or those of one kind.
    std::size_t halve(std::size_t begin, std::size_t end, const Range& range) {
        Reference* const from = &references_[begin];
        Reference* const to = from + (end - begin);
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

    std::uint32_t collapse(std::uint32_t root) {
        Children children{root};
        std::size_t count = 1;
        const BinaryNode& from = binary_[root];
        if (from.items == 0) {
            count = 0;
            gather(from.first, from.given[0], children, count);
            gather(from.first + 1, WideBvh::width - from.given[0], children, count);
        }
        // Where any hit will do the last that is met is visited first.
        const float area = binary_[0].box.half_area();
        std::stable_sort(children.begin(), children.begin() + static_cast<std::ptrdiff_t>(count),
                         [&](std::uint32_t a, std::uint32_t b) {
                             return binary_[a].promise(area) < binary_[b].promise(area);
                         });
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

    /// Adds what takes so many places for a binary node.
    void gather(std::uint32_t from, std::size_t places, Children& children,
                std::size_t& count) const {
        const BinaryNode& node = binary_[from];
        while (places > 1 && node.given[places - 1] == 0) {
            --places;
        }
        if (places == 1) {
            children[count++] = from;
            return;
        }
        const std::size_t given = node.given[places - 1];
        gather(node.first, given, children, count);
        gather(node.first + 1, places - given, children, count);
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
    SurfaceAreaCuts cuts_;
    std::size_t count_;
    std::unique_ptr<Reference[]> references_;
    std::unique_ptr<BinaryNode[]> binary_;
    std::atomic<std::uint32_t> used_{0};
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
