#include "accel/intersector.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "accel/huge_pages.h"

namespace raytree {

template <class T> WideBvh hierarchy_of(const ShapeSet<T>& shapes) {
    HugePageVector<WideBvh::Item> items(shapes.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, items.size(), 4096), [&](const auto& r) {
        for (std::size_t k = r.begin(); k < r.end(); ++k) {
            const auto id = static_cast<PrimitiveId>(k);
            items[k] = {shapes.bounds(id), LeafFilter::kind_of(shapes[id])};
        }
    });
    WideBvh::Config config;
    if constexpr (std::same_as<T, double>) {
        // Eight shapes are filtered at once. Boxes fit cones badly, and are all the filter others
        // have.
        config.leaf_items = {8, 8, 4, 1};
    }
    return WideBvh(items, config);
}

template WideBvh hierarchy_of<float>(const ShapeSet<float>&);
template WideBvh hierarchy_of<double>(const ShapeSet<double>&);
template WideBvh hierarchy_of<Quad>(const ShapeSet<Quad>&);

}  // namespace raytree
