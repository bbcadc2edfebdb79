#include "drawing/thinned_mesh.h"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "app/scenes.h"
#include "drawing/scene_mesh.h"

namespace raytree::inspector {
namespace {

double height(double x, double z) { return 0.3 * std::sin(3 * x) * std::cos(2 * z); }

/// A hilly square from 0 to 1, of 2 n^2 triangles.
raytree::Mesh hills(int n) {
    raytree::Mesh mesh;
    for (int row = 0; row <= n; ++row) {
        for (int column = 0; column <= n; ++column) {
            const double x = static_cast<double>(column) / n, z = static_cast<double>(row) / n;
            mesh.vertices.push_back({x, height(x, z), z});
        }
    }
    const auto corner = [n](int column, int row) {
        return raytree::Mesh::Corner{row * (n + 1) + column, -1};
    };
    for (int row = 0; row < n; ++row) {
        for (int column = 0; column < n; ++column) {
            mesh.triangles.push_back(
                {corner(column, row), corner(column, row + 1), corner(column + 1, row)});
            mesh.triangles.push_back(
                {corner(column + 1, row), corner(column, row + 1), corner(column + 1, row + 1)});
        }
    }
    return mesh;
}

TEST_CASE("app: a thinned mesh has no more triangles than it may, and lies where the mesh does") {
    const raytree::Mesh mesh = hills(200);
    constexpr std::size_t most = 4000;
    const raytree::Mesh few = thinned(mesh, most);
    CHECK(few.triangles.size() <= most);
    CHECK(few.triangles.size() > most / 4);
    double area = 0;
    for (const auto& triangle : few.triangles) {
        std::array<Point3, 3> p;
        for (std::size_t k = 0; k < 3; ++k) {
            p[k] = few.vertices[static_cast<std::size_t>(triangle[k].vertex)];
            CHECK(std::abs(p[k].y - height(p[k].x, p[k].z)) < 0.01);
            const Point3 normal = few.normals[static_cast<std::size_t>(triangle[k].normal)];
            const double slope_x = 0.9 * std::cos(3 * p[k].x) * std::cos(2 * p[k].z);
            CHECK(-normal.x / normal.y == doctest::Approx(slope_x).epsilon(0.1).scale(1));
        }
        area += 0.5 * std::abs((p[1].x - p[0].x) * (p[2].z - p[0].z) -
                               (p[1].z - p[0].z) * (p[2].x - p[0].x));
    }
    CHECK(area > 0.9);  // from above nothing of the square is left out but its rim
    CHECK(area < 1.05);
}

TEST_CASE(
    "app: a mesh that is small enough is drawn as it is, a large one thinned, which is told") {
    for (const int n : {20, 400}) {
        Scene scene = test::glass_ball_scene();
        scene.objects.resize(1);
        scene.objects[0].shape = hills(n);
        const auto document = test::document_of(scene);
        const SceneMesh drawn = scene_mesh(*document, extent_of(*document), 0.01);
        const auto all = static_cast<std::size_t>(2 * n * n);
        const bool large = n == 400;
        CHECK(drawn.thinned_from == (large ? all : 0));
        CHECK((drawn.faces.triangle_count() < all) == large);
        CHECK(drawn.faces.triangle_count() <= 40'000);
    }
}

}  // namespace
}  // namespace raytree::inspector
