#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "accel/huge_pages.h"
#include "geometry/box.h"
#include "geometry/ray.h"

namespace raytree {

/// A hierarchy of boxes over a list of items, eight children to a node. Boxes are floats rounded
/// outwards, in coordinates centred on the scene and scaled to its size; whatever happens in a leaf
/// happens in the arithmetic of whoever visits it. No item whose box the ray meets is ever passed
/// over: the rounding of boxes and of the float copy of the ray is bounded together, in two
/// constants for each axis (Ize, "Robust BVH ray traversal", JCGT 2(2), 2013).
class WideBvh {
  public:
    static constexpr int width = 8;
    static constexpr std::size_t kinds = 4;
    static constexpr std::size_t most_items = std::size_t(1) << 26;

    struct Config {
        /// How many items of each kind a leaf may hold, 1 to 8; testing so many costs about as much
        /// as testing the boxes of a node. A leaf holds items of one kind.
        std::array<std::uint8_t, kinds> leaf_items = {4, 4, 4, 4};
        int bins = 16;               ///< of the surface-area heuristic (Wald, 2007)
        float cost_of_split = 0.3F;  ///< in tests of a node
    };

    struct Item {
        Box box;
        std::uint8_t kind = 0;
    };

    /// What a child is: a node, or a leaf of up to eight items that follow each other in `items`.
    class Ref {
      public:
        Ref() = default;
        static Ref to_node(std::size_t place) { return Ref(static_cast<std::uint32_t>(place)); }
        static Ref to_leaf(std::size_t first, std::size_t count, unsigned kind) {
            return Ref(1U << 31 | kind << 29 | static_cast<std::uint32_t>(count - 1) << 26 |
                       static_cast<std::uint32_t>(first));
        }
        static Ref of(std::uint32_t bits) { return Ref(bits); }

        bool is_leaf() const { return bits_ >> 31 != 0; }
        std::size_t node() const { return bits_; }
        unsigned kind() const { return bits_ >> 29 & 3; }
        std::size_t count() const { return (bits_ >> 26 & 7) + 1; }
        std::size_t first() const { return bits_ & (most_items - 1); }

      private:
        explicit Ref(std::uint32_t bits) : bits_(bits) {}
        std::uint32_t bits_ = 0;
    };

    struct alignas(64) Node {
        std::array<std::array<float, width>, 3> min;
        std::array<std::array<float, width>, 3> max;
        std::array<Ref, width> child;
        /// For rays of each octant of directions the order of the children, the farthest first: at
        /// place k, three bits at 3 * octant (after the ordered traversal of Fuetterling et al.,
        /// "Accelerated single ray tracing for wide vector units", HPG 2017).
        std::array<std::uint32_t, width> order;
    };

    /// A ray in the coordinates of the boxes.
    struct BoxRay {
        std::array<float, 3> inverse;    ///< of the direction, finite
        std::array<float, 3> near_bias;  ///< subtracted from box * inverse at the near planes
        std::array<float, 3> far_bias;   ///< and at the far planes
        double scale = 1;                ///< t here is (t in the world - start) * scale
        double start = 0;
        double error = 0;     ///< bound on how far double has moved a far origin, and t with it
        Vec3<double> origin;  ///< where t here is 0

        /// An upper bound of the world's t in these coordinates.
        float upper(double t) const {
            const double here = (t - start) * scale;
            return here < -error ? -1.0F : static_cast<float>(std::max(here, 0.0) * (1 + 0x1p-20));
        }
    };

    WideBvh() = default;
    /// Throws std::length_error for more than `most_items`. `names`: what each item is called in
    /// `items()`; its place in the list if empty.
    WideBvh(std::span<const Item> items, const Config& config,
            std::span<const std::uint32_t> names = {});

    bool empty() const { return items_.empty(); }
    std::size_t node_count() const { return nodes_.size(); }
    std::size_t bytes() const {
        return nodes_.size() * sizeof(Node) + items_.size() * sizeof(std::uint32_t);
    }
    std::span<const Node> nodes() const { return nodes_; }
    /// The items by their names, leaf by leaf.
    std::span<const std::uint32_t> items() const { return items_; }
    const Vec3<double>& center() const { return center_; }
    /// A power of two: `(p - center()) * scale()` is within 1 of 0 for every p in the boxes.
    double scale() const { return scale_; }
    /// Calls `visit(ref)` for each leaf.
    template <class Visit> void for_each_leaf(Visit&& visit) const;

    BoxRay prepare(const Vec3<double>& origin, const Vec3<double>& direction) const {
        BoxRay ray;
        prepare(origin, direction, ray);
        return ray;
    }
    /// The same, written where it is to be: a ray written number by number is slow to copy.
    void prepare(const Vec3<double>& origin, const Vec3<double>& direction, BoxRay& ray) const;

    /// Visits, roughly from near to far, every item whose box the ray meets at 0 <= t <= t_max.
    /// `visit(items, t_max)` gets the items of a leaf and returns the t_max from then on, in the
    /// world: less than before where a hit was found, negative to stop. `ray` is in the world.
    template <class Visit> void traverse(const BoxRay& ray, double t_max, Visit&& visit) const;

    /// At most so many children wait to be visited at any time.
    static constexpr std::size_t stack_size = 64 * width;

  private:
    friend class WideBvhBuilder;

    struct Pending {
        float near;
        Ref child;
    };

    using Distances = std::array<float, width>;

    /// Which children's boxes the ray meets before t_max, a bit for each, and where it enters them.
    static unsigned enter_children(const Node& node, const BoxRay& ray, float t_max,
                                   Distances& near);

    Vec3<double> center_{0.0};
    double scale_ = 1;
    HugePageVector<Node> nodes_;
    std::vector<std::uint32_t> items_;
};

inline void WideBvh::prepare(const Vec3<double>& origin, const Vec3<double>& direction,
                             BoxRay& ray) const {
    constexpr float flattest = 1e-18F;
    constexpr double float_roundoff = 0x1p-24;
    constexpr double double_roundoff = 0x1p-53;
    constexpr double farthest = 1e18;
    constexpr double scene_radius = 2;  // boxes lie within 1 of the centre on each axis

    ray.origin = (origin - center_) * scale_;
    ray.scale = scale_;
    ray.start = 0;
    double away = largest_component(ray.origin);
    if (away > 2 * scene_radius) {
        away = length(ray.origin);
        const double skipped = away - scene_radius;
        ray.origin = along(ray.origin, skipped, direction);
        // Rays that lead away may be so far now that products would be infinite, and the boxes of
        // children that are not there no numbers, and met. The error is far larger there.
        for (int axis = 0; axis < 3; ++axis) {
            ray.origin[axis] = std::min(std::max(ray.origin[axis], -farthest), farthest);
        }
        ray.start = skipped / scale_;
    }
    ray.error = std::min(16 * double_roundoff * (away + 1), 16 * farthest);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int a = static_cast<int>(axis);
        const auto slope = static_cast<float>(direction[a]);
        ray.inverse[axis] = 1 / std::copysign(std::max(std::abs(slope), flattest), slope);
        const auto inverse = static_cast<double>(ray.inverse[axis]);
        // 8 float roundings for the two products, the difference, the slope and its inverse; the
        // rest is what double has lost on the way from a far origin.
        const double reach = std::abs(ray.origin[a]) + 1;
        const double error = std::abs(inverse) * (8 * float_roundoff * reach + ray.error);
        ray.near_bias[axis] = static_cast<float>(inverse * ray.origin[a] + error);
        ray.far_bias[axis] = static_cast<float>(inverse * ray.origin[a] - error);
    }
}

template <class Visit> void WideBvh::for_each_leaf(Visit&& visit) const {
    for (const Node& node : nodes_) {
        for (std::size_t k = 0; k < width; ++k) {
            if (node.min[0][k] <= node.max[0][k] && node.child[k].is_leaf()) {
                visit(node.child[k]);
            }
        }
    }
}

// The loop over the children has a fixed length and no branch: compilers make vector code of it.
inline unsigned WideBvh::enter_children(const Node& node, const BoxRay& ray, float t_max,
                                        Distances& near) {
    Distances far;
    near.fill(0);
    far.fill(t_max);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const float inverse = ray.inverse[axis];
        const auto& first = inverse < 0 ? node.max[axis] : node.min[axis];
        const auto& second = inverse < 0 ? node.min[axis] : node.max[axis];
        for (std::size_t k = 0; k < width; ++k) {
            const float enter = first[k] * inverse - ray.near_bias[axis];
            const float leave = second[k] * inverse - ray.far_bias[axis];
            near[k] = enter > near[k] ? enter : near[k];
            far[k] = leave < far[k] ? leave : far[k];
        }
    }
    unsigned met = 0;
    for (std::size_t k = 0; k < width; ++k) {
        met |= (near[k] <= far[k] ? 1U : 0U) << k;
    }
    return met;
}

template <class Visit>
void WideBvh::traverse(const BoxRay& ray, double t_max, Visit&& visit) const {
    if (empty()) {
        return;
    }
    std::array<Pending, stack_size> stack;
    std::size_t top = 0;
    stack[top++] = {0, Ref::to_node(0)};
    float limit = ray.upper(t_max);
    Distances near;
    while (top > 0) {
        const Pending next = stack[--top];
        if (next.near > limit) {
            continue;
        }
        if (next.child.is_leaf()) {
            const double shorter =
                visit(items().subspan(next.child.first(), next.child.count()), t_max);
            if (shorter < 0) {
                return;
            }
            if (shorter < t_max) {
                t_max = shorter;
                limit = ray.upper(t_max);
            }
            continue;
        }
        const Node& node = nodes_[next.child.node()];
        const std::size_t bottom = top;
        for (unsigned met = enter_children(node, ray, limit, near); met != 0; met &= met - 1) {
            const auto k = static_cast<std::size_t>(std::countr_zero(met));
            std::size_t place = top++;
            for (; place > bottom && stack[place - 1].near < near[k]; --place) {
                stack[place] = stack[place - 1];
            }
            stack[place] = {near[k], node.child[k]};
        }
    }
}

}  // namespace raytree
