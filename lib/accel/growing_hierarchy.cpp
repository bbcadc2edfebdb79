#include "accel/growing_hierarchy.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>

#include "accel/intersector.h"
#include "scene/progress.h"

namespace raytree {
namespace {

/// A grid over the centres of some of the shapes: enough to know where they lie. What lies outside
/// belongs to the cells at the border.
class Grid {
  public:
    explicit Grid(const ShapeSet<double>& shapes) {
        constexpr std::size_t looked_at = 1024;
        Box box;
        for (std::size_t k = 0; k < shapes.size(); k += shapes.size() / looked_at + 1) {
            box.include(shapes.bounds(static_cast<PrimitiveId>(k)).center());
        }
        // So many across that on a surface, which fills cells by the square, a cell has about as
        // many shapes as are soon built upon.
        constexpr double shapes_a_cell = 512;
        const double across =
            std::clamp(std::sqrt(static_cast<double>(shapes.size()) / shapes_a_cell), 1.0, 128.0);
        const double side = std::max(largest_component<double>(0.5 * box.size()) * 2 / across,
                                     std::numeric_limits<double>::min());
        low_ = box.min;
        for (int axis = 0; axis < 3; ++axis) {
            inverse_side_[axis] = 1 / side;
            last_[axis] = std::min(std::floor(box.size()[axis] / side), across);
        }
    }

    std::size_t size() const {
        return static_cast<std::size_t>((last_.x + 1) * (last_.y + 1) * (last_.z + 1));
    }
    std::uint32_t cell_of(const Vec3<double>& center) const {
        const Vec3<double> p = (center - low_) * inverse_side_;
        const auto place = [&](int axis) {
            return static_cast<std::uint32_t>(std::min(std::max(p[axis], 0.0), last_[axis]));
        };
        const auto width = [&](int axis) { return static_cast<std::uint32_t>(last_[axis]) + 1; };
        return (place(2) * width(1) + place(1)) * width(0) + place(0);
    }

  private:
    Vec3<double> low_{0.0}, inverse_side_{0.0}, last_{0.0};
};

}  // namespace

GrowingHierarchy::GrowingHierarchy(const ShapeSet<double>& shapes) : shapes_(shapes) {
    WideBvh::Config config;
    config.leaf_items = {1, 1, 1, 1};
    above_ = WideBvh(sort_into_cells(), config);
    grown_ = std::vector<Grown>(cells_.size());
}

/// Sorts by counting; the boxes of the cells that hold something.
std::vector<WideBvh::Item> GrowingHierarchy::sort_into_cells() {
    const std::size_t count = shapes_.size();
    if (count == 0) {
        return {};
    }
    const Grid grid(shapes_);
    std::vector<std::uint32_t> cell_of(count);
    std::vector<std::uint32_t> in_cell(grid.size(), 0);  // how many, then which of the full cells
    std::vector<Box> boxes(grid.size());
    ProgressCounter progress("sorting into cells");
    for (std::size_t k = 0; k < count; ++k) {
        progress.at(k, count);
        const Box box = shapes_.bounds(static_cast<PrimitiveId>(k));
        const std::uint32_t cell = grid.cell_of(box.center());
        cell_of[k] = cell;
        ++in_cell[cell];
        boxes[cell].include(box);
    }
    std::vector<WideBvh::Item> items;
    std::uint32_t begin = 0;
    for (std::size_t cell = 0; cell < in_cell.size(); ++cell) {
        if (in_cell[cell] > 0) {
            cells_.push_back({begin, begin});
            begin += in_cell[cell];
            in_cell[cell] = static_cast<std::uint32_t>(items.size());
            items.push_back({boxes[cell]});
        }
    }
    order_.resize(count);
    for (std::size_t k = 0; k < count; ++k) {
        order_[cells_[in_cell[cell_of[k]]].end++] = static_cast<std::uint32_t>(k);
    }
    return items;
}

const Searched& GrowingHierarchy::inside(std::uint32_t cell) const {
    Grown& grown = grown_[cell];
    // Isolated, so that this thread does not meanwhile take on work that waits for this cell.
    std::call_once(grown.once, [&] {
        tbb::this_task_arena::isolate([&] {
            const Cell& of = cells_[cell];
            grown.searched = std::make_unique<Searched>(
                searched_among(shapes_, std::span(order_).subspan(of.begin, of.end - of.begin)));
        });
    });
    return *grown.searched;
}

std::size_t GrowingHierarchy::grown() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(grown_, [](const Grown& g) { return g.searched != nullptr; }));
}

Hit<double> GrowingHierarchy::closest(const Query<double>& query, std::size_t* tests) const {
    Hit<double> best;
    Query<double> nearer = query;
    const auto look_inside = [&](std::span<const std::uint32_t> cells, double t_max) -> double {
        for (const std::uint32_t cell : cells) {
            const Hit<double> hit = kernels().closest(inside(cell), nearer, tests);
            if (hit.primitive != no_primitive && (best.primitive == no_primitive || hit < best)) {
                best = hit;
                t_max = hit.t;  // of equal t another shape may be the first
                nearer.interval.to = std::nextafter(hit.t, Real<double>::infinity);
            }
        }
        return t_max;
    };
    above_.traverse(above_.prepare(query.ray.origin, query.ray.direction), query.interval.to,
                    look_inside);
    return best;
}

PrimitiveId GrowingHierarchy::any(const Query<double>& query, std::size_t* tests) const {
    PrimitiveId met = no_primitive;
    const auto look_inside = [&](std::span<const std::uint32_t> cells, double t_max) -> double {
        for (const std::uint32_t cell : cells) {
            met = kernels().any(inside(cell), query, tests);
            if (met != no_primitive) {
                return -1;
            }
        }
        return t_max;
    };
    above_.traverse(above_.prepare(query.ray.origin, query.ray.direction), query.interval.to,
                    look_inside);
    return met;
}

}  // namespace raytree
