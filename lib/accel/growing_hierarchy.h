#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "accel/kernels.h"

namespace raytree {

/// A hierarchy that is built only where its rays go. Its shapes are first sorted into the cells of
/// a coarse grid, by their centres; above the cells stands a small hierarchy, and inside of one a
/// hierarchy is built when the first ray comes by. A ray or a pixel's tree needs few cells of a
/// scene, so the first answers come many times as soon as from the hierarchy over all shapes, and
/// they are the same.
class GrowingHierarchy {
  public:
    /// The shapes must outlive it.
    explicit GrowingHierarchy(const ShapeSet<double>& shapes);

    /// As of the kernels; the primitive is no_primitive where nothing is met. May be asked by
    /// several threads at a time.
    Hit<double> closest(const Query<double>& query, std::size_t* tests) const;
    PrimitiveId any(const Query<double>& query, std::size_t* tests) const;

    /// As WideBvh::traverse; the items are shapes.
    template <class Visit> void traverse(const Vec3<double>& origin, const Vec3<double>& direction,
                                         double t_max, Visit&& visit) const;

    std::size_t cells() const { return cells_.size(); }
    /// Cells in which rays have been.
    std::size_t grown() const;

  private:
    struct Cell {
        std::uint32_t begin = 0, end = 0;  ///< its shapes, in `order_`
    };
    struct Grown {
        std::once_flag once;
        std::unique_ptr<Searched> searched;
    };

    std::vector<WideBvh::Item> sort_into_cells();
    const Searched& inside(std::uint32_t cell) const;

    const ShapeSet<double>& shapes_;
    std::vector<std::uint32_t> order_;  ///< all shapes, cell by cell
    std::vector<Cell> cells_;
    mutable std::vector<Grown> grown_;  ///< by cell
    WideBvh above_;
};

template <class Visit> void GrowingHierarchy::traverse(const Vec3<double>& origin,
                                                       const Vec3<double>& direction, double t_max,
                                                       Visit&& visit) const {
    const auto look_inside = [&](std::span<const std::uint32_t> cells, double limit) -> double {
        for (const std::uint32_t cell : cells) {
            const WideBvh& bvh = inside(cell).bvh;
            bvh.traverse(bvh.prepare(origin, direction), limit,
                         [&](std::span<const std::uint32_t> items, double) -> double {
                             limit = visit(items, limit);
                             return limit;
                         });
            if (limit < 0) {
                return limit;
            }
        }
        return limit;
    };
    above_.traverse(above_.prepare(origin, direction), t_max, look_inside);
}

}  // namespace raytree
