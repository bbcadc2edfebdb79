#include "trace/z_buffer.h"

#include <algorithm>

namespace raytree {

std::vector<ZBufferStep> z_buffer_at(const World<double>& world, int i, int j) {
    const Ray<double> ray = world.camera.primary(i, j);
    const double z_of_t = inner(world.camera.forward(), ray.direction);
    NoTestCount count;
    std::vector<ZBufferStep> steps;
    for (const Hit<double>& hit :
         world.shapes.all(ray, no_primitive, {world.camera.near_along(ray.direction)}, count)) {
        const std::size_t object = world.shapes.shapes()[hit.primitive].object;
        const bool known = std::ranges::any_of(
            steps, [&](const ZBufferStep& step) { return step.object == object; });
        if (!known) {  // the nearest of its surfaces comes first
            steps.push_back({object, hit.t * z_of_t, hit.t, false});
        }
    }
    std::ranges::sort(steps, {}, &ZBufferStep::object);
    double nearest = Real<double>::infinity;
    for (ZBufferStep& step : steps) {
        step.written = step.z < nearest;
        nearest = std::min(nearest, step.z);
    }
    return steps;
}

}  // namespace raytree
