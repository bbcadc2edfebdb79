#include "drawing/thinned_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <unordered_map>
#include <unordered_set>

#include "drawing/extent.h"

namespace raytree::inspector {
namespace {

/// Vertices by the cells of a grid with so many cells along its longest side.
class Cells {
  public:
    Cells(const raytree::Mesh& mesh, const Span3& box, double across) : of_(mesh.vertices.size()) {
        const Point3 size = box.high - box.low;
        const double side = std::max({size.x, size.y, size.z}) / across;
        std::unordered_map<std::uint64_t, int> places;
        for (std::size_t k = 0; k < of_.size(); ++k) {
            const Point3 at = (mesh.vertices[k] - box.low) / side;
            const auto part = [](double x) { return static_cast<std::uint64_t>(x) & 0x1FFFFF; };
            const std::uint64_t cell = part(at.x) << 42 | part(at.y) << 21 | part(at.z);
            const auto [place, is_new] = places.try_emplace(cell, static_cast<int>(sums_.size()));
            if (is_new) {
                sums_.emplace_back(0.0);
                counts_.push_back(0);
            }
            of_[k] = place->second;
            sums_[static_cast<std::size_t>(of_[k])] += mesh.vertices[k];
            ++counts_[static_cast<std::size_t>(of_[k])];
        }
    }

    int of(const raytree::Mesh::Corner& corner) const {
        return of_[static_cast<std::size_t>(corner.vertex)];
    }
    std::size_t count() const { return sums_.size(); }
    Point3 middle(std::size_t cell) const {
        return sums_[cell] / static_cast<double>(counts_[cell]);
    }

  private:
    std::vector<int> of_;  ///< by vertex
    std::vector<Point3> sums_;
    std::vector<int> counts_;
};

struct ThreeHash {
    std::size_t operator()(const std::array<int, 3>& three) const {
        std::uint64_t hash = 0;
        for (const int one : three) {
            hash = (hash ^ static_cast<std::uint64_t>(one)) * 0x9E3779B97F4A7C15;
        }
        return hash ^ hash >> 32;
    }
};

raytree::Mesh joined(const raytree::Mesh& mesh, const Cells& cells) {
    raytree::Mesh result;
    result.file = mesh.file;
    result.normals.assign(cells.count(), Point3(0));
    std::unordered_set<std::array<int, 3>, ThreeHash> known;
    for (const raytree::Mesh::Triangle& triangle : mesh.triangles) {
        const std::array<int, 3> of = {cells.of(triangle[0]), cells.of(triangle[1]),
                                       cells.of(triangle[2])};
        const auto vertex = [&](std::size_t k) {
            return mesh.vertices[static_cast<std::size_t>(triangle[k].vertex)];
        };
        const Point3 normal = glm::cross(vertex(1) - vertex(0), vertex(2) - vertex(0));
        for (const int cell : of) {
            result.normals[static_cast<std::size_t>(cell)] += normal;
        }
        std::array<int, 3> sorted = of;
        std::ranges::sort(sorted);
        if (sorted[0] != sorted[1] && sorted[1] != sorted[2] && known.insert(sorted).second) {
            result.triangles.push_back(
                {raytree::Mesh::Corner{of[0], of[0]}, {of[1], of[1]}, {of[2], of[2]}});
        }
    }
    result.vertices.reserve(cells.count());
    for (std::size_t cell = 0; cell < cells.count(); ++cell) {
        result.vertices.push_back(cells.middle(cell));
    }
    return result;
}

/// Where opposite sides have become one, their normals may have summed up to nothing.
void mend_normals(raytree::Mesh& mesh) {
    for (raytree::Mesh::Triangle& triangle : mesh.triangles) {
        for (raytree::Mesh::Corner& corner : triangle) {
            const Point3& normal = mesh.normals[static_cast<std::size_t>(corner.normal)];
            corner.normal = glm::length(normal) > 0 ? corner.normal : -1;
        }
    }
}

}  // namespace

raytree::Mesh thinned(const raytree::Mesh& mesh, std::size_t most) {
    if (mesh.triangles.size() <= most || mesh.vertices.empty()) {
        return mesh;
    }
    Span3 box{mesh.vertices.front(), mesh.vertices.front()};
    for (const Point3& vertex : mesh.vertices) {
        box.add(vertex);
    }
    // On a surface, cells grow with the square of how many there are across, and a cell has about
    // two triangles.
    double across = std::sqrt(static_cast<double>(most) / 2);
    while (true) {
        raytree::Mesh result = joined(mesh, Cells(mesh, box, across));
        if (result.triangles.size() <= most) {
            mend_normals(result);
            return result;
        }
        across *= 0.7;
    }
}

}  // namespace raytree::inspector
