#include "accel/surface_area_cut.h"

#include <algorithm>

namespace raytree {
namespace {

/// Whether centres so far apart can be told into bins: closer ones, in a scene some 10^30 times
/// as large, have no float to be multiplied with.
bool can_be_cut(float extent) { return extent > 1e-30F; }

bool can_be_cut(const FloatBox& centers, int axis) {
    return can_be_cut(centers.max[axis] - centers.min[axis]);
}

/// Which bin a centre falls into.
struct Scale {
    Lanes low, factor;
    float last;

    Scale(const FloatBox& centers, std::size_t bins)
        : low(centers.min), last(static_cast<float>(bins - 1)) {
        const Lanes size = centers.max - centers.min;
        for (int axis = 0; axis < 4; ++axis) {
            factor[axis] = can_be_cut(size[axis]) ? static_cast<float>(bins) / size[axis] : 0.0F;
        }
    }
    int bin_of(const Reference& reference, int axis) const {
        const float place = (reference.twice_center()[axis] - low[axis]) * factor[axis];
        // The factor of centres that all but coincide is infinite.
        return place > 0 ? static_cast<int>(std::min(place, last)) : 0;
    }
};

}  // namespace

SurfaceAreaCuts::SurfaceAreaCuts(const WideBvh::Config& config)
    : bins_(std::min(static_cast<std::size_t>(config.bins), max_bins)),
      leaf_items_(config.leaf_items) {
    for (std::size_t k = 0; k < WideBvh::kinds; ++k) {
        reciprocal_[k] = ((std::uint64_t(1) << 32) - 1) / leaf_items_[k] + 1;
    }
}

Cut SurfaceAreaCuts::best(std::span<const Reference> items, const FloatBox& centers) const {
    Cut best;
    if (items.size() <= few_items) {
        for (int axis = 0; axis < 3; ++axis) {
            if (can_be_cut(centers, axis)) {
                cut_few(items, axis, best);
            }
        }
        return best;
    }
    const Scale scale(centers, bins_);
    std::array<Bins, 3> bins;
    for (const Reference& reference : items) {
        for (int axis = 0; axis < 3; ++axis) {
            bins[static_cast<std::size_t>(axis)]
                [static_cast<std::size_t>(scale.bin_of(reference, axis))]
                    .include(reference);
        }
    }
    for (int axis = 0; axis < 3; ++axis) {
        if (can_be_cut(centers, axis)) {
            sweep(bins[static_cast<std::size_t>(axis)], axis, best);
        }
    }
    return best;
}

std::size_t SurfaceAreaCuts::divide(std::span<Reference> items, const FloatBox& centers,
                                    const Cut& cut) const {
    const auto in_front = [&](const auto& is_in_front) {
        const auto behind = std::partition(items.begin(), items.end(), is_in_front);
        return static_cast<std::size_t>(behind - items.begin());
    };
    if (cut.bin < 0) {
        return in_front([&](const Reference& reference) {
            return reference.twice_center()[cut.axis] <= cut.center;
        });
    }
    const Scale scale(centers, bins_);
    return in_front(
        [&](const Reference& reference) { return scale.bin_of(reference, cut.axis) <= cut.bin; });
}

/// The best cut across an axis, between any two of a few items.
void SurfaceAreaCuts::cut_few(std::span<const Reference> items, int axis, Cut& best) const {
    struct Placed {
        float center;
        const Reference* reference;
    };
    std::array<Placed, few_items> placed;
    for (std::size_t k = 0; k < items.size(); ++k) {
        const float center = items[k].twice_center()[axis];
        std::size_t place = k;
        for (; place > 0 && placed[place - 1].center > center; --place) {
            placed[place] = placed[place - 1];
        }
        placed[place] = {center, &items[k]};
    }
    std::array<float, few_items> right_cost{};
    ItemGroup side;
    for (std::size_t k = items.size() - 1; k > 0; --k) {
        side.include(*placed[k].reference);
        right_cost[k] = cost(side);
    }
    side = {};
    for (std::size_t k = 0; k + 1 < items.size(); ++k) {
        side.include(*placed[k].reference);
        const float total = cost(side) + right_cost[k + 1];
        if (total < best.cost && placed[k].center < placed[k + 1].center) {
            best = {axis, -1, total, placed[k].center};
        }
    }
}

void SurfaceAreaCuts::sweep(const Bins& bins, int axis, Cut& best) const {
    std::array<float, max_bins> right_cost{};
    ItemGroup side;
    for (std::size_t k = bins_ - 1; k > 0; --k) {
        side.include(bins[k]);
        right_cost[k] = cost(side);
    }
    side = {};
    for (std::size_t k = 0; k + 1 < bins_; ++k) {
        side.include(bins[k]);
        const float total = cost(side) + right_cost[k + 1];
        if (total < best.cost) {
            best = {axis, static_cast<int>(k), total, 0};
        }
    }
}

/// Infinite for a side without items, so that no cut leaves one empty.
float SurfaceAreaCuts::cost(const ItemGroup& side) const {
    if (side.count() == 0) {
        return FloatBox::infinite;
    }
    std::uint32_t leaves = 0;
    for (std::size_t k = 0; k < WideBvh::kinds; ++k) {
        leaves += leaves_of(side.items[k], k);
    }
    return side.box.half_area() * static_cast<float>(leaves);
}

/// How many leaves so many items of a kind fill: divided by a product, exact below 2^29.
std::uint32_t SurfaceAreaCuts::leaves_of(std::uint32_t items, std::size_t kind) const {
    return static_cast<std::uint32_t>((items + leaf_items_[kind] - 1) * reciprocal_[kind] >> 32);
}

}  // namespace raytree
