#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "accel/intersector.h"

/// The hierarchies of the lecture, to be looked at and counted, not to be fast.
namespace raytree {

enum class LectureKind {
    brute_force,  ///< no hierarchy: every shape is asked
    spheres,      ///< a binary tree of bounding spheres
    boxes,        ///< a binary tree of bounding boxes
    octree,       ///< a cube cut into eight again and again; a shape is in every cell it touches
};

struct BoundingSphere {
    Vec3<double> center{0.0};
    double radius = 0;
};

/// Where a ray enters and leaves a volume; nothing is met where `enter > leave`.
struct VolumePassage {
    double enter = 1;
    double leave = 0;
    bool met() const { return enter <= leave; }
};

VolumePassage pass(const Box& box, const Vec3<double>& origin, const Vec3<double>& direction);
VolumePassage pass(const BoundingSphere& sphere, const Vec3<double>& origin,
                   const Vec3<double>& direction);

/// A tree of volumes over the shapes of a scene; what a ray does not meet, it need not open.
class LectureHierarchy {
  public:
    struct Node {
        std::variant<Box, BoundingSphere> volume;
        int depth = 0;
        std::vector<std::uint32_t> children;  ///< places in `nodes()`
        std::vector<PrimitiveId> items;       ///< of a leaf
    };

    LectureHierarchy() = default;
    /// `boxes`: of each shape, by its PrimitiveId.
    LectureHierarchy(LectureKind kind, std::span<const Box> boxes);

    LectureKind kind() const { return kind_; }
    const std::vector<Node>& nodes() const { return nodes_; }  ///< the root first; may be empty

    /// Visits from near to far what the ray may meet before `t_max`. `visitor.volume(node, passage,
    /// t_max)` is told of every volume that is tested; `visitor.items(items, t_max)` gets the
    /// shapes of a leaf and returns the t_max from then on, negative to stop.
    template <class Visitor> void traverse(const Vec3<double>& origin,
                                           const Vec3<double>& direction, double t_max,
                                           Visitor& visitor) const;

  private:
    struct Pending {
        double enter;
        std::uint32_t node;
    };

    void split(std::uint32_t node, std::span<const Box> boxes, std::vector<PrimitiveId> items);
    void divide(std::uint32_t node, std::span<const Box> boxes, std::vector<PrimitiveId> items);
    std::uint32_t add(std::variant<Box, BoundingSphere> volume, int depth);

    LectureKind kind_ = LectureKind::brute_force;
    std::vector<Node> nodes_;
};

/// Counts what a traversal tests.
struct LectureCount {
    std::size_t volumes = 0;
    std::size_t shapes = 0;
};

/// The intersector's questions, answered through a hierarchy of the lecture; the same answers.
class LectureIntersector {
  public:
    /// The shapes given must outlive it.
    LectureIntersector(LectureKind kind, const ShapeSet<double>& shapes);

    const LectureHierarchy& hierarchy() const { return hierarchy_; }

    std::optional<Hit<double>> closest(const Ray<double>& ray, PrimitiveId leaving,
                                       Interval<double> interval, LectureCount& count) const;
    bool any(const Ray<double>& ray, PrimitiveId leaving, Interval<double> interval,
             LectureCount& count) const;
    std::vector<Hit<double>> all(const Ray<double>& ray, PrimitiveId leaving,
                                 Interval<double> interval, LectureCount& count) const;

    /// One volume that a ray was tested against.
    struct Step {
        std::uint32_t node = 0;
        VolumePassage passage;
        bool opened = false;                 ///< it is met, and before the nearest hit so far
        std::vector<PrimitiveId> tested;     ///< of a leaf that is opened
        std::optional<Hit<double>> nearest;  ///< after this step
    };
    /// The steps in which `closest` finds its answer.
    std::vector<Step> replay(const Ray<double>& ray, PrimitiveId leaving,
                             Interval<double> interval) const;

  private:
    const ShapeSet<double>& shapes_;
    LectureHierarchy hierarchy_;
};

template <class Visitor> void LectureHierarchy::traverse(const Vec3<double>& origin,
                                                         const Vec3<double>& direction,
                                                         double t_max, Visitor& visitor) const {
    if (nodes_.empty()) {
        return;
    }
    const auto passage_of = [&](std::uint32_t node) {
        return std::visit([&](const auto& volume) { return pass(volume, origin, direction); },
                          nodes_[node].volume);
    };
    const auto ask = [&](std::uint32_t node) {
        const VolumePassage passage = passage_of(node);
        const bool open = passage.met() && passage.leave >= 0 && passage.enter <= t_max;
        visitor.volume(node, passage, open);
        return open ? std::optional(std::max(passage.enter, 0.0)) : std::nullopt;
    };
    std::vector<Pending> pending;
    if (kind_ == LectureKind::brute_force) {
        visitor.items(0, std::span(nodes_[0].items), t_max);
        return;
    }
    if (const auto enter = ask(0)) {
        pending.push_back({*enter, 0});
    }
    std::vector<Pending> met;
    while (!pending.empty()) {
        const Pending next = pending.back();
        pending.pop_back();
        if (next.enter > t_max) {
            continue;
        }
        const Node& node = nodes_[next.node];
        if (!node.items.empty()) {
            t_max = visitor.items(next.node, std::span(node.items), t_max);
            if (t_max < 0) {
                return;
            }
        }
        met.clear();
        for (const std::uint32_t child : node.children) {
            if (const auto enter = ask(child)) {
                met.push_back({*enter, child});
            }
        }
        std::ranges::stable_sort(met, std::ranges::greater(), &Pending::enter);
        pending.insert(pending.end(), met.begin(), met.end());
    }
}

}  // namespace raytree
