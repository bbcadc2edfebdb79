#include "accel/intersector.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "accel/huge_pages.h"

namespace raytree {
namespace {

template <class T> WideBvh::Config config_of() {
    WideBvh::Config config;
    if constexpr (std::same_as<T, double>) {
        // Eight shapes are filtered at once. Boxes fit cones badly, and are all the filter others
        // have.
        config.leaf_items = {8, 8, 4, 1};
    }
    return config;
}

}  // namespace

template <class T> WideBvh hierarchy_of(const ShapeSet<T>& shapes) {
    HugePageVector<WideBvh::Item> items(shapes.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, items.size(), 4096), [&](const auto& r) {
        for (std::size_t k = r.begin(); k < r.end(); ++k) {
            const auto id = static_cast<PrimitiveId>(k);
            items[k] = {shapes.bounds(id), LeafFilter::kind_of(shapes[id])};
        }
    });
    return WideBvh(items, config_of<T>());
}

template WideBvh hierarchy_of<float>(const ShapeSet<float>&);
template WideBvh hierarchy_of<double>(const ShapeSet<double>&);
template WideBvh hierarchy_of<Quad>(const ShapeSet<Quad>&);

Searched searched_of(const ShapeSet<double>& shapes) {
    Searched searched{&shapes, hierarchy_of(shapes)};
    searched.filter = LeafFilter(shapes, searched.bvh);
    return searched;
}

Searched searched_among(const ShapeSet<double>& shapes, std::span<const PrimitiveId> some) {
    std::vector<WideBvh::Item> items;
    items.reserve(some.size());
    for (const PrimitiveId id : some) {
        items.push_back({shapes.bounds(id), LeafFilter::kind_of(shapes[id])});
    }
    Searched searched{&shapes, WideBvh(items, config_of<double>(), some)};
    searched.filter = LeafFilter(shapes, searched.bvh);
    return searched;
}

DoubleSearch::DoubleSearch(const ShapeSet<double>& shapes, Build build) : shapes_(shapes) {
    if (build == Build::where_rays_go && shapes.size() >= fewest_to_grow) {
        growing_ = std::make_unique<GrowingHierarchy>(shapes);
    } else {
        whole();
    }
}

void DoubleSearch::build_whole() const {
    // Isolated, so that this thread does not meanwhile take on work that waits for the whole.
    std::call_once(once_, [&] {
        tbb::this_task_arena::isolate([&] { whole_ = searched_of(shapes_); });
        is_whole_.store(true, std::memory_order_release);
    });
}

}  // namespace raytree
