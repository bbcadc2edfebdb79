#include "accel/wide_bvh.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>

namespace raytree {
namespace {

float round_down(double x) {
    const auto f = static_cast<float>(x);
    return static_cast<double>(f) > x ? std::nextafter(f, -std::numeric_limits<float>::infinity())
                                      : f;
}

float round_up(double x) { return -round_down(-x); }

}  // namespace

/// Builds a binary hierarchy top down by the binned surface-area heuristic (Wald, "On fast
/// construction of SAH-based bounding volume hierarchies", 2007), then gives each node the eight
/// descendants of largest area as children.
class WideBvhBuilder {
  public:
    WideBvhBuilder(WideBvh& bvh, std::span<const Box> boxes, const WideBvh::Config& config)
        : bvh_(bvh), boxes_(boxes), config_(config), binary_(2 * boxes.size()) {}

    void build() {
        bvh_.items_.resize(boxes_.size());
        std::iota(bvh_.items_.begin(), bvh_.items_.end(), 0U);
        const std::uint32_t root = used_++;
        split(root, 0, boxes_.size(), 0);
        place_in_unit_space(binary_[root].box);
        collapse(root);
    }

  private:
    struct BinaryNode {
        Box box;
        std::uint32_t first = 0;  ///< of two neighbouring children, or of the items
        std::uint32_t items = 0;  ///< 0: not a leaf
    };
    struct Bin {
        Box box;
        std::size_t items = 0;
    };
    struct Cut {
        int axis = -1;
        int bin = 0;
        double cost = std::numeric_limits<double>::infinity();
    };

    static constexpr int max_bins = 64;
    static constexpr int deepest_heuristic_split = 40;
    static constexpr std::size_t parallel_items = 8192;

    void split(std::uint32_t place, std::size_t begin, std::size_t end, int depth) {
        BinaryNode& node = binary_[place];
        Box centers;
        for (std::size_t k = begin; k < end; ++k) {
            const Box& box = boxes_[bvh_.items_[k]];
            node.box.include(box);
            centers.include(box.center());
        }
        if (end - begin <= config_.leaf_items) {
            node.first = static_cast<std::uint32_t>(begin);
            node.items = static_cast<std::uint32_t>(end - begin);
            return;
        }
        const std::size_t middle = divide(begin, end, centers, depth);
        const std::uint32_t children = used_.fetch_add(2);
        node.first = children;
        const auto left = [&] { split(children, begin, middle, depth + 1); };
        const auto right = [&] { split(children + 1, middle, end, depth + 1); };
        if (end - begin > parallel_items) {
            tbb::parallel_invoke(left, right);
        } else {
            left();
            right();
        }
    }

    std::size_t divide(std::size_t begin, std::size_t end, const Box& centers, int depth) {
        const auto items = bvh_.items_.begin();
        const auto from = items + static_cast<std::ptrdiff_t>(begin);
        const auto to = items + static_cast<std::ptrdiff_t>(end);
        if (depth < deepest_heuristic_split) {
            const Cut cut = best_cut(begin, end, centers);
            if (cut.axis >= 0) {
                const auto middle = std::partition(from, to, [&](std::uint32_t item) {
                    return bin_of(item, cut.axis, centers) <= cut.bin;
                });
                return static_cast<std::size_t>(middle - items);
            }
        }
        const Vec3<double> size = centers.size();
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const std::size_t middle = begin + (end - begin) / 2;
        std::nth_element(from, items + static_cast<std::ptrdiff_t>(middle), to,
                         [&](std::uint32_t a, std::uint32_t b) {
                             const double ca = boxes_[a].center()[axis];
                             const double cb = boxes_[b].center()[axis];
                             return ca < cb || (ca == cb && a < b);
                         });
        return middle;
    }

    int bin_of(std::uint32_t item, int axis, const Box& centers) const {
        const double share = (boxes_[item].center()[axis] - centers.min[axis]) /
                             (centers.max[axis] - centers.min[axis]);
        return std::clamp(static_cast<int>(share * config_.bins), 0, config_.bins - 1);
    }

    Cut best_cut(std::size_t begin, std::size_t end, const Box& centers) const {
        Cut best;
        for (int axis = 0; axis < 3; ++axis) {
            if (!(centers.max[axis] > centers.min[axis])) {
                continue;
            }
            std::array<Bin, max_bins> bins;
            for (std::size_t k = begin; k < end; ++k) {
                const std::uint32_t item = bvh_.items_[k];
                Bin& bin = bins[static_cast<std::size_t>(bin_of(item, axis, centers))];
                bin.box.include(boxes_[item]);
                ++bin.items;
            }
            sweep(bins, axis, best);
        }
        return best;
    }

    void sweep(const std::array<Bin, max_bins>& bins, int axis, Cut& best) const {
        const auto count = static_cast<std::size_t>(config_.bins);
        std::array<double, max_bins> right_cost{};
        Bin side;
        for (std::size_t k = count - 1; k > 0; --k) {
            side.box.include(bins[k].box);
            side.items += bins[k].items;
            right_cost[k] = cost(side);
        }
        side = {};
        for (std::size_t k = 0; k + 1 < count; ++k) {
            side.box.include(bins[k].box);
            side.items += bins[k].items;
            const double total = cost(side) + right_cost[k + 1];
            if (side.items > 0 && total < best.cost) {
                best = {axis, static_cast<int>(k), total};
            }
        }
    }

    /// Infinite for a side without items, so that no cut leaves one empty.
    static double cost(const Bin& side) {
        return side.items == 0 ? std::numeric_limits<double>::infinity()
                               : side.box.half_area() * static_cast<double>(side.items);
    }

    void place_in_unit_space(const Box& all) {
        bvh_.center_ = all.center();
        const double extent = largest_component<double>(0.5 * all.max - 0.5 * all.min);
        int exponent = 0;
        std::frexp(extent, &exponent);
        bvh_.scale_ = extent > 0 ? std::ldexp(1.0, -std::clamp(exponent, -1000, 1000)) : 1.0;
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
                bvh_.nodes_[place].child[k] = child;
            }
        }
        return place;
    }

    std::size_t widest_inner(const std::array<std::uint32_t, WideBvh::width>& children,
                             std::size_t count) const {
        std::size_t widest = count;
        double area = -1;
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
            const int a = static_cast<int>(axis);
            const double c = bvh_.center_[a];
            node.min[axis][k] = from ? round_down((from->box.min[a] - c) * bvh_.scale_)
                                     : std::numeric_limits<float>::infinity();
            node.max[axis][k] = from ? round_up((from->box.max[a] - c) * bvh_.scale_)
                                     : -std::numeric_limits<float>::infinity();
        }
        node.child[k] = from ? from->first : 0;
        node.item_count[k] = from ? static_cast<std::uint8_t>(from->items) : WideBvh::no_child;
    }

    WideBvh& bvh_;
    std::span<const Box> boxes_;
    WideBvh::Config config_;
    std::vector<BinaryNode> binary_;
    std::atomic<std::uint32_t> used_{0};
};

WideBvh::WideBvh(std::span<const Box> boxes, const Config& config) {
    if (!boxes.empty()) {
        WideBvhBuilder(*this, boxes, config).build();
    }
}

WideBvh::BoxRay WideBvh::prepare(const Vec3<double>& origin, const Vec3<double>& direction) const {
    constexpr double flattest = 1e-18;
    constexpr double float_roundoff = 0x1p-24;
    constexpr double double_roundoff = 0x1p-53;
    constexpr double scene_radius = 2;  // boxes lie within 1 of the centre on each axis

    Vec3<double> o = (origin - center_) * scale_;
    const double away = length(o);
    BoxRay ray;
    ray.scale = scale_;
    const double skipped = away > 2 * scene_radius ? away - scene_radius : 0;
    o = along(o, skipped, direction);
    ray.start = skipped / scale_;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int a = static_cast<int>(axis);
        const double slope =
            std::copysign(std::max(std::abs(direction[a]), flattest), direction[a]);
        ray.inverse[axis] = static_cast<float>(1 / slope);
        const double inverse = static_cast<double>(ray.inverse[axis]);
        // 8 float roundings for the two products, the difference and the inverse; the rest is what
        // double has lost on the way from a far origin.
        const double reach = std::abs(o[a]) + 1;
        const double error =
            std::abs(inverse) * (8 * float_roundoff * reach + 16 * double_roundoff * (away + 1));
        ray.near_bias[axis] = static_cast<float>(inverse * o[a] + error);
        ray.far_bias[axis] = static_cast<float>(inverse * o[a] - error);
    }
    return ray;
}

}  // namespace raytree
