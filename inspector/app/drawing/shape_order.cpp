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

Point3 triple(const std::vector<float>& list, std::int32_t place) {
    const float* const first = &list[3 * static_cast<std::size_t>(place)];
    return {first[0], first[1], first[2]};
}

/// Whether a triangle is turned away from the eye: at its first corner, of tiny shapes as a whole.
bool is_away(const Mesh& mesh, const std::int32_t* corners, const Point3& eye, bool tiny) {
    Point3 normal = triple(mesh.normals, corners[0]);
    if (tiny) {
        normal += triple(mesh.normals, corners[1]) + triple(mesh.normals, corners[2]);
    }
    return glm::dot(eye - triple(mesh.points, corners[0]), normal) < 0;
}

/// Those that are turned away from the eye first: seen through a round shape's front is its back.
void add_triangles(const SceneMesh& mesh, const ObjectFaces& object, const Point3& eye,
                   std::vector<std::int32_t>& out) {
    const std::vector<std::int32_t>& triangles = mesh.faces.triangles;
    std::vector<std::int32_t> towards;
    for (std::size_t k = 3 * object.first; k < 3 * (object.first + object.count); k += 3) {
        const bool away = is_away(mesh.faces, &triangles[k], eye, object.tiny);
        if (!away || !object.tiny) {
            auto& list = away ? out : towards;
            list.insert(list.end(), {triangles[k], triangles[k + 1], triangles[k + 2]});
        }
    }
    out.insert(out.end(), towards.begin(), towards.end());
}

}  // namespace

std::vector<std::size_t> drawing_order(const SceneMesh& mesh, const Extent& extent,
                                       const Point3& eye) {
    const Point3 middle = extent.seen.centre();
    struct Place {
        int layer;  ///< 0 behind the rest, 2 in front of it
        double distance;
        std::size_t object;
    };
    std::vector<Place> places;
    for (std::size_t k = 0; k < mesh.objects.size(); ++k) {
        const ObjectFaces& object = mesh.objects[k];
        const int layer = !object.flat ? 1 : is_behind_the_rest(object, middle, eye) ? 0 : 2;
        places.push_back({layer, glm::length(object.centre - eye), k});
    }
    std::ranges::sort(places, [](const Place& a, const Place& b) {
        return a.layer != b.layer ? a.layer < b.layer : a.distance > b.distance;
    });
    std::vector<std::size_t> order;
    for (const Place& place : places) {
        order.push_back(place.object);
    }
    return order;
}

std::vector<std::int32_t> triangles_of(const SceneMesh& mesh, std::span<const std::size_t> objects,
                                       const Point3& eye) {
    std::vector<std::int32_t> triangles;
    triangles.reserve(mesh.faces.triangles.size());
    for (const std::size_t k : objects) {
        add_triangles(mesh, mesh.objects[k], eye, triangles);
    }
    return triangles;
}

Mesh part_of(const SceneMesh& mesh, std::span<const std::size_t> objects, const Point3& eye) {
    Mesh part;
    const auto copy = [](const auto& from, auto& to, std::size_t first, std::size_t count) {
        const auto begin = from.begin() + static_cast<std::ptrdiff_t>(first);
        to.insert(to.end(), begin, begin + static_cast<std::ptrdiff_t>(count));
    };
    for (const std::size_t k : objects) {
        const ObjectFaces& object = mesh.objects[k];
        const auto moved = static_cast<std::int32_t>(part.points.size() / 3) -
                           static_cast<std::int32_t>(object.first_point);
        copy(mesh.faces.points, part.points, 3 * object.first_point, 3 * object.points);
        copy(mesh.faces.normals, part.normals, 3 * object.first_point, 3 * object.points);
        copy(mesh.faces.colours, part.colours, 4 * object.first_point, 4 * object.points);
        const std::size_t first = part.triangles.size();
        add_triangles(mesh, object, eye, part.triangles);
        for (std::size_t at = first; at < part.triangles.size(); ++at) {
            part.triangles[at] += moved;
        }
    }
    return part;
}

}  // namespace raytree::inspector
