#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

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
    struct Config {
        std::size_t leaf_items = 4;  ///< at most, unless boxes coincide
        int bins = 16;               ///< of the surface-area heuristic (Wald, 2007)
    };

    /// A ray in the coordinates of the boxes.
    struct BoxRay {
        std::array<float, 3> inverse;    ///< of the direction, finite
        std::array<float, 3> near_bias;  ///< subtracted from box * inverse at the near planes
        std::array<float, 3> far_bias;   ///< and at the far planes
        double scale = 1;                ///< t here is (t in the world - start) * scale
        double start = 0;

        /// An upper bound of the world's t in these coordinates.
        float upper(double t) const {
            const double here = (t - start) * scale;
            return here < 0 ? -1.0F : static_cast<float>(here * (1 + 0x1p-20));
        }
    };

    WideBvh() = default;
    explicit WideBvh(std::span<const Box> boxes) : WideBvh(boxes, Config{}) {}
    WideBvh(std::span<const Box> boxes, const Config& config);

    bool empty() const { return items_.empty(); }
    std::size_t node_count() const { return nodes_.size(); }
    std::size_t bytes() const {
        return nodes_.size() * sizeof(Node) + items_.size() * sizeof(std::uint32_t);
    }

    BoxRay prepare(const Vec3<double>& origin, const Vec3<double>& direction) const;

    /// Visits, roughly from near to far, every item whose box the ray meets at 0 <= t <= t_max.
    /// `visit(items, t_max)` gets the items of a leaf and returns the t_max from then on, in the
    /// world: less than before where a hit was found, negative to stop. `ray` is in the world.
    template <class Visit> void traverse(const BoxRay& ray, double t_max, Visit&& visit) const;

  private:
    friend class WideBvhBuilder;

    static constexpr int width = 8;
    static constexpr std::uint8_t inner = 0;  ///< item_count of a child that is a node
    static constexpr std::uint8_t no_child = 255;
    static constexpr int stack_size = 64 * width;

    struct alignas(64) Node {
        std::array<std::array<float, width>, 3> min;
        std::array<std::array<float, width>, 3> max;
        std::array<std::uint32_t, width> child;  ///< a node, or the first of a leaf's items
        std::array<std::uint8_t, width> item_count;
    };

    struct Pending {
        float near;
        std::uint32_t child;
        std::uint32_t item_count;
    };

    using Distances = std::array<float, width>;

    /// Which children's boxes the ray meets before t_max, a bit for each, and where it enters them.
    static unsigned enter_children(const Node& node, const BoxRay& ray, float t_max,
                                   Distances& near);

    template <class Visit> void traverse_here(const BoxRay& ray, double t_max, Visit&& visit) const;
    template <class Visit>
    void traverse_with_avx2(const BoxRay& ray, double t_max, Visit&& visit) const;

    Vec3<double> center_{0.0};
    double scale_ = 1;
    std::vector<Node> nodes_;
    std::vector<std::uint32_t> items_;
};

// The loop over the children has a fixed length and no branch: compilers make vector code of it.
[[gnu::always_inline]] inline unsigned WideBvh::enter_children(const Node& node, const BoxRay& ray,
                                                               float t_max, Distances& near) {
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
[[gnu::always_inline]] inline void WideBvh::traverse_here(const BoxRay& ray, double t_max,
                                                          Visit&& visit) const {
    std::array<Pending, stack_size> stack;
    std::size_t top = 0;
    stack[top++] = {0, 0, inner};
    float limit = ray.upper(t_max);
    Distances near;
    while (top > 0) {
        const Pending next = stack[--top];
        if (next.near > limit) {
            continue;
        }
        if (next.item_count != inner) {
            const double shorter = visit(
                std::span<const std::uint32_t>(items_.data() + next.child, next.item_count), t_max);
            if (shorter < 0) {
                return;
            }
            if (shorter < t_max) {
                t_max = shorter;
                limit = ray.upper(t_max);
            }
            continue;
        }
        const Node& node = nodes_[next.child];
        const std::size_t bottom = top;
        for (unsigned met = enter_children(node, ray, limit, near); met != 0; met &= met - 1) {
            const auto k = static_cast<std::size_t>(std::countr_zero(met));
            std::size_t place = top++;
            for (; place > bottom && stack[place - 1].near < near[k]; --place) {
                stack[place] = stack[place - 1];
            }
            stack[place] = {near[k], node.child[k], node.item_count[k]};
        }
    }
}

#if defined(__x86_64__) && defined(__GNUC__)
// Vector units differ in speed alone: the same operations in the same order, none contracted.
template <class Visit>
[[gnu::target("avx2,fma"), gnu::flatten]] void WideBvh::traverse_with_avx2(const BoxRay& ray,
                                                                           double t_max,
                                                                           Visit&& visit) const {
    traverse_here(ray, t_max, visit);
}
#endif

template <class Visit>
void WideBvh::traverse(const BoxRay& ray, double t_max, Visit&& visit) const {
    if (empty()) {
        return;
    }
#if defined(__x86_64__) && defined(__GNUC__)
    static const bool has_avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    if (has_avx2) {
        traverse_with_avx2(ray, t_max, visit);
        return;
    }
#endif
    traverse_here(ray, t_max, visit);
}

}  // namespace raytree
