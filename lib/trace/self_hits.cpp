#include "trace/self_hits.h"

#include "trace/ray_list.h"

namespace raytree {

template <class T> SelfHits self_hits(const World<T>& world) {
    SelfHits result;
    NoTestCount count;
    for (const ListedRay<T>& listed : rays_of_picture(world)) {
        if (listed.leaving == no_primitive) {
            continue;
        }
        ++result.rays;
        const auto right = world.shapes.closest(listed.ray, listed.leaving, listed.interval, count);
        const Ray<T> careless{listed.ray.origin, listed.ray.direction, T(0)};
        const auto found = world.shapes.closest(careless, no_primitive, listed.interval, count);
        // To within far more than rounding, and far less than a hit on the start itself.
        const bool same = right.has_value() == found.has_value() &&
                          (!right || (right->primitive == found->primitive &&
                                      abs(right->t - found->t) <= right->t / 100));
        result.wrong += same ? 0 : 1;
    }
    return result;
}

template SelfHits self_hits(const World<float>&);
template SelfHits self_hits(const World<double>&);

}  // namespace raytree
