#include "scene/planarity.h"

#include <vector>

namespace raytree {
namespace {

double diagonal(std::span<const Vec3<double>> vertices) {
    Vec3<double> low = vertices[0];
    Vec3<double> high = vertices[0];
    for (const Vec3<double>& vertex : vertices) {
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = min_of(low[axis], vertex[axis]);
            high[axis] = max_of(high[axis], vertex[axis]);
        }
    }
    return length(high - low);
}

}  // namespace

Planarity planarity_of(std::span<const Vec3<double>> vertices) {
    Planarity result;
    result.extent = diagonal(vertices);
    if (!isfinite(result.extent) || result.extent == 0) {
        return result;
    }
    // In units of the extent nothing overflows; from the first vertex nothing is lost to an origin
    // far away.
    std::vector<Vec3<double>> relative;
    relative.reserve(vertices.size());
    Vec3<double> mean(0);
    for (const Vec3<double>& vertex : vertices) {
        relative.push_back((vertex - vertices[0]) / result.extent);
        mean += relative.back() / static_cast<double>(vertices.size());
    }
    Vec3<double> twice_area(0);
    for (std::size_t k = 0; k < relative.size(); ++k) {
        twice_area += outer(relative[k], relative[(k + 1) % relative.size()]);
    }
    const double size = length(twice_area);
    result.area = size / 2;
    if (size > 0) {
        result.normal = twice_area / size;
    }
    for (const Vec3<double>& vertex : relative) {
        result.off_plane = max_of(result.off_plane, abs(inner(result.normal, vertex - mean)));
    }
    return result;
}

}  // namespace raytree
