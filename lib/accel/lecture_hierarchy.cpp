#include "accel/lecture_hierarchy.h"

#include <glm/common.hpp>

#include <numeric>

namespace raytree {
namespace {

constexpr std::size_t leaf_items = 2;
constexpr int deepest_cell = 8;

/// Wider than all rounding in finding hits and in passing volumes.
constexpr double margin = 1e-9;

Box wider(Box box) {
    box.pad(margin * (1 + largest_component(box.min) + largest_component(box.max)));
    return box;
}

Box box_of(std::span<const Box> boxes, std::span<const PrimitiveId> items) {
    Box all;
    for (const PrimitiveId item : items) {
        all.include(boxes[item]);
    }
    return wider(all);
}

/// Around the middle of the common box: not the smallest sphere, but the one that is quickly found.
BoundingSphere sphere_of(std::span<const Box> boxes, std::span<const PrimitiveId> items) {
    const Box all = box_of(boxes, items);
    BoundingSphere sphere{all.center(), 0};
    for (const PrimitiveId item : items) {
        const Box& box = boxes[item];
        const Vec3<double> reach =
            glm::max(glm::abs(box.min - sphere.center), glm::abs(box.max - sphere.center));
        sphere.radius = std::max(sphere.radius, length(reach));
    }
    sphere.radius += margin * (1 + sphere.radius + largest_component(sphere.center));
    return sphere;
}

bool overlap(const Box& a, const Box& b) {
    bool both = true;
    for (int axis = 0; axis < 3; ++axis) {
        both = both && a.min[axis] <= b.max[axis] && b.min[axis] <= a.max[axis];
    }
    return both;
}

/// The octant `k` of a cell: bit 0 is the upper half in x, bit 1 in y, bit 2 in z.
Box octant(const Box& cell, unsigned k) {
    const Vec3<double> middle = cell.center();
    Box box = cell;
    for (int axis = 0; axis < 3; ++axis) {
        (k >> axis & 1U ? box.min : box.max)[axis] = middle[axis];
    }
    return box;
}

Box cube_around(const Box& box) {
    const Vec3<double> half(0.5 * largest_component(box.size()));
    Box cube;
    cube.include(box.center() - half);
    cube.include(box.center() + half);
    return cube;
}

std::vector<PrimitiveId> all_items(std::size_t count) {
    std::vector<PrimitiveId> items(count);
    std::iota(items.begin(), items.end(), PrimitiveId{0});
    return items;
}

}  // namespace

VolumePassage pass(const Box& box, const Vec3<double>& origin, const Vec3<double>& direction) {
    VolumePassage passage{-Real<double>::infinity, Real<double>::infinity};
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0) {
            if (origin[axis] < box.min[axis] || origin[axis] > box.max[axis]) {
                return {};
            }
            continue;
        }
        const double a = (box.min[axis] - origin[axis]) / direction[axis];
        const double b = (box.max[axis] - origin[axis]) / direction[axis];
        passage.enter = std::max(passage.enter, std::min(a, b));
        passage.leave = std::min(passage.leave, std::max(a, b));
    }
    return passage;
}

VolumePassage pass(const BoundingSphere& sphere, const Vec3<double>& origin,
                   const Vec3<double>& direction) {
    const Vec3<double> f = origin - sphere.center;
    const double middle = -inner(f, direction);
    const Vec3<double> foot = along(f, middle, direction);
    const double square = sphere.radius * sphere.radius - inner(foot, foot);
    if (square < 0) {
        return {};
    }
    const double half = std::sqrt(square);
    return {middle - half, middle + half};
}

LectureHierarchy::LectureHierarchy(LectureKind kind, std::span<const Box> boxes) : kind_(kind) {
    if (boxes.empty()) {
        return;
    }
    std::vector<PrimitiveId> items = all_items(boxes.size());
    const Box all = box_of(boxes, items);
    switch (kind) {
        case LectureKind::brute_force:
            nodes_[add(all, 0)].items = std::move(items);
            return;
        case LectureKind::octree:
            divide(add(wider(cube_around(all)), 0), boxes, std::move(items));
            return;
        case LectureKind::boxes:
            split(add(all, 0), boxes, std::move(items));
            return;
        case LectureKind::spheres: {
            const BoundingSphere around = sphere_of(boxes, items);
            split(add(around, 0), boxes, std::move(items));
            return;
        }
    }
}

std::uint32_t LectureHierarchy::add(std::variant<Box, BoundingSphere> volume, int depth) {
    nodes_.push_back({std::move(volume), depth, {}, {}});
    return static_cast<std::uint32_t>(nodes_.size() - 1);
}

/// Half of the shapes to either side, along the axis in which their middles are spread most.
void LectureHierarchy::split(std::uint32_t node, std::span<const Box> boxes,
                             std::vector<PrimitiveId> items) {
    if (items.size() <= leaf_items) {
        nodes_[node].items = std::move(items);
        return;
    }
    Box middles;
    for (const PrimitiveId item : items) {
        middles.include(boxes[item].center());
    }
    const Vec3<double> spread = middles.size();
    const int axis = spread.x >= spread.y && spread.x >= spread.z ? 0
                     : spread.y >= spread.z                       ? 1
                                                                  : 2;
    const auto half = items.begin() + static_cast<std::ptrdiff_t>(items.size() / 2);
    std::nth_element(items.begin(), half, items.end(), [&](PrimitiveId a, PrimitiveId b) {
        const double x = boxes[a].center()[axis];
        const double y = boxes[b].center()[axis];
        return x < y || (x == y && a < b);
    });
    for (std::vector<PrimitiveId> part : {std::vector<PrimitiveId>(items.begin(), half),
                                          std::vector<PrimitiveId>(half, items.end())}) {
        const int depth = nodes_[node].depth + 1;
        const std::uint32_t child = kind_ == LectureKind::spheres
                                        ? add(sphere_of(boxes, part), depth)
                                        : add(box_of(boxes, part), depth);
        nodes_[node].children.push_back(child);
        split(child, boxes, std::move(part));
    }
}

void LectureHierarchy::divide(std::uint32_t node, std::span<const Box> boxes,
                              std::vector<PrimitiveId> items) {
    const int depth = nodes_[node].depth;
    if (items.size() <= leaf_items || depth >= deepest_cell) {
        nodes_[node].items = std::move(items);
        return;
    }
    const Box cell = std::get<Box>(nodes_[node].volume);
    std::vector<std::pair<Box, std::vector<PrimitiveId>>> parts;
    std::size_t kept = 0;
    for (unsigned k = 0; k < 8; ++k) {
        const Box box = octant(cell, k);
        std::vector<PrimitiveId> inside;
        std::ranges::copy_if(items, std::back_inserter(inside),
                             [&](PrimitiveId item) { return overlap(wider(box), boxes[item]); });
        kept += inside.size();
        if (!inside.empty()) {
            parts.emplace_back(wider(box), std::move(inside));
        }
    }
    if (kept >= 6 * items.size()) {  // cutting further only copies
        nodes_[node].items = std::move(items);
        return;
    }
    for (auto& [box, inside] : parts) {
        const std::uint32_t child = add(box, depth + 1);
        nodes_[node].children.push_back(child);
        divide(child, boxes, std::move(inside));
    }
}

}  // namespace raytree
