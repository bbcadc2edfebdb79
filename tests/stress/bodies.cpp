#include "bodies.h"

#include <map>
#include <numbers>

namespace raytree::stress {
namespace {

void add_triangle(Mesh& mesh, int a, int b, int c) {
    mesh.triangles.push_back({{{a, -1}, {b, -1}, {c, -1}}});
}

/// Splits every triangle of a ball into four.
void subdivide(Mesh& mesh) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
        const auto [place, is_new] = middles.emplace(std::minmax(a, b), 0);
        if (is_new) {
            place->second = static_cast<int>(mesh.vertices.size());
            const auto at = [&](int k) { return mesh.vertices[static_cast<std::size_t>(k)]; };
            const Point between = at(a) + at(b);
            mesh.vertices.push_back(UnitVec3<double>::of(between).vec());
        }
        return place->second;
    };
    Mesh finer;
    for (const Mesh::Triangle& t : mesh.triangles) {
        const int a = t[0].vertex, b = t[1].vertex, c = t[2].vertex;
        const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        add_triangle(finer, a, ab, ca);
        add_triangle(finer, ab, b, bc);
        add_triangle(finer, ca, bc, c);
        add_triangle(finer, ab, bc, ca);
    }
    mesh.triangles = std::move(finer.triangles);
}

/// A closed body of revolution from tip to tip; `rings` are (height, radius) pairs in between.
Mesh turned(const Point& center, double top, double bottom,
            const std::vector<std::pair<double, double>>& rings, int slices) {
    Mesh mesh;
    mesh.vertices = {center + Point(0, 0, top), center + Point(0, 0, bottom)};
    for (const auto& [height, radius] : rings) {
        for (int k = 0; k < slices; ++k) {
            const double angle = 2 * std::numbers::pi * k / slices;
            mesh.vertices.push_back(
                center + Point(radius * std::cos(angle), radius * std::sin(angle), height));
        }
    }
    const auto at = [&](std::size_t ring, int k) {
        return 2 + static_cast<int>(ring) * slices + k % slices;
    };
    for (int k = 0; k < slices; ++k) {
        add_triangle(mesh, 0, at(0, k), at(0, k + 1));
        add_triangle(mesh, 1, at(rings.size() - 1, k + 1), at(rings.size() - 1, k));
        for (std::size_t ring = 0; ring + 1 < rings.size(); ++ring) {
            add_triangle(mesh, at(ring, k), at(ring + 1, k), at(ring + 1, k + 1));
            add_triangle(mesh, at(ring, k), at(ring + 1, k + 1), at(ring, k + 1));
        }
    }
    return mesh;
}

}  // namespace

Object& add(Scene& scene, Shape shape) {
    if (scene.materials.empty()) {
        scene.materials.push_back({});
    }
    Object object;
    object.name = "object" + std::to_string(scene.objects.size());
    object.shape = std::move(shape);
    return scene.objects.emplace_back(std::move(object));
}

Mesh rough_ball(Random& random, const Point& center, double size, int subdivisions,
                double roughness) {
    Mesh mesh;
    mesh.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (const int x : {0, 1}) {
        for (const int y : {2, 3}) {
            for (const int z : {4, 5}) {
                const bool turned = ((x + y + z) & 1) != 0;
                add_triangle(mesh, x, turned ? z : y, turned ? y : z);
            }
        }
    }
    for (int k = 0; k < subdivisions; ++k) {
        subdivide(mesh);
    }
    for (Point& vertex : mesh.vertices) {
        vertex = center + size * (1 - roughness * random.uniform(0, 1)) * vertex;
    }
    return mesh;
}

Mesh needle_fan(const Point& center, double size, int spokes, double tip_height) {
    return turned(center, tip_height, -tip_height, {{0, size}}, spokes);
}

Mesh sliver_ball(const Point& center, double size, int slices) {
    std::vector<std::pair<double, double>> rings;
    for (const double angle : {0.001, 0.4, 1.2, 1.5707, 1.571, 2.2, 3.0}) {
        rings.emplace_back(size * std::cos(angle), size * std::sin(angle));
    }
    return turned(center, size, -size, rings, slices);
}

Affine stretched(Random& random, double scale, double stretch, const Point& translation) {
    const Vec3<double> x = random.direction();
    const Vec3<double> y = random.across(x);
    const Vec3<double> z = outer(x, y);
    const Vec3<double> by(scale * random.log_uniform(1 / stretch, stretch),
                          scale * random.log_uniform(1 / stretch, stretch),
                          scale * random.log_uniform(1 / stretch, stretch));
    Affine result;
    for (int row = 0; row < 3; ++row) {
        const auto k = static_cast<std::size_t>(row);
        result[k] = {by.x * x[row], by.y * y[row], by.z * z[row], translation[row]};
    }
    return result;
}

}  // namespace raytree::stress
