#include <algorithm>
#include <glm/geometric.hpp>

#include "drawing/scene_mesh.h"

namespace raytree::inspector {
namespace {

/// Large flat shapes stand behind all others as long as these lie between them and the viewer.
bool is_behind_the_rest(const ObjectFaces& object, const Point3& middle, const Point3& eye) {
    return glm::dot(middle - object.centre, object.normal) *
               glm::dot(eye - object.centre, object.normal) >
           0;
}

}  // namespace

std::vector<std::int32_t> sorted_triangles(const SceneMesh& mesh, const Extent& extent,
                                           const Point3& eye) {
    const Point3 middle = extent.seen.centre();
    struct Place {
        int layer;  ///< 0 behind the rest, 2 in front of it
        double distance;
        const ObjectFaces* object;
    };
    std::vector<Place> order;
    for (const ObjectFaces& object : mesh.objects) {
        const int layer = !object.flat ? 1 : is_behind_the_rest(object, middle, eye) ? 0 : 2;
        order.push_back({layer, glm::length(object.centre - eye), &object});
    }
    std::ranges::sort(order, [](const Place& a, const Place& b) {
        return a.layer != b.layer ? a.layer < b.layer : a.distance > b.distance;
    });
    std::vector<std::int32_t> triangles;
    triangles.reserve(mesh.faces.triangles.size());
    for (const Place& place : order) {
        const auto from =
            mesh.faces.triangles.begin() + static_cast<std::ptrdiff_t>(3 * place.object->first);
        triangles.insert(triangles.end(), from,
                         from + static_cast<std::ptrdiff_t>(3 * place.object->count));
    }
    return triangles;
}

}  // namespace raytree::inspector
