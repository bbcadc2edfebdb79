#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>

#include "accel/wide_bvh.h"

/// Where a list of items is cut in two while a hierarchy is built over them.
namespace raytree {

/// Three coordinates and one more lane, whatever it holds, in one register of any processor.
using Lanes = float __attribute__((vector_size(16)));

/// A box in the coordinates of the hierarchy.
struct FloatBox {
    static constexpr float infinite = std::numeric_limits<float>::infinity();

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

/// Some items: their boxes' union, and how many there are of each kind.
struct ItemGroup {
    FloatBox box;
    std::array<std::uint32_t, WideBvh::kinds> items{};

    void include(const Reference& reference) {
        box.include(reference.box);
        ++items[reference.kind];
    }
    void include(const ItemGroup& other) {
        box.include(other.box);
        for (std::size_t k = 0; k < WideBvh::kinds; ++k) {
            items[k] += other.items[k];
        }
    }
    std::uint32_t count() const { return items[0] + items[1] + items[2] + items[3]; }
};

/// Across an axis: the items up to a bin on one side, or where `bin` is negative those up to a
/// doubled centre.
struct Cut {
    int axis = -1;  ///< negative: there is no cut that keeps items on both sides
    int bin = 0;
    float cost = FloatBox::infinite;
    float center = 0;
};

/// Finds cuts by the surface-area heuristic, in bins (Wald, "On fast construction of SAH-based
/// bounding volume hierarchies", 2007); a few items are cut between any two.
class SurfaceAreaCuts {
  public:
    explicit SurfaceAreaCuts(const WideBvh::Config& config);

    /// `centers`: the box around the items' doubled centres.
    Cut best(std::span<const Reference> items, const FloatBox& centers) const;

    /// Puts the items of a cut's one side before those of the other, and returns how many they are.
    std::size_t divide(std::span<Reference> items, const FloatBox& centers, const Cut& cut) const;

  private:
    static constexpr std::size_t max_bins = 16;
    /// So few are not put into bins.
    static constexpr std::size_t few_items = 8;
    using Bins = std::array<ItemGroup, max_bins>;

    void cut_few(std::span<const Reference> items, int axis, Cut& best) const;
    void sweep(const Bins& bins, int axis, Cut& best) const;
    float cost(const ItemGroup& side) const;
    std::uint32_t leaves_of(std::uint32_t items, std::size_t kind) const;

    std::size_t bins_;
    std::array<std::uint8_t, WideBvh::kinds> leaf_items_;
    std::array<std::uint64_t, WideBvh::kinds>
        reciprocal_;  ///< of leaf_items_, times 2^32, rounded up
};

}  // namespace raytree
