// What features of the menu Explain put into the 3D view lets the scene be seen.

#include "drawing/explained_mesh.h"

#include <doctest/doctest.h>

#include <cmath>

#include "app/scenes.h"
#include "support/scenes.h"

namespace raytree::inspector {
namespace {

/// A floor, and so many small squares in rows above it, which all throw shadows.
Scene squares_over_a_floor(int count) {
    Scene scene = test::glass_ball_scene();
    scene.objects.clear();
    raytree::test::add(scene, Polygon{{{-9, 0, -9}, {-9, 0, 9}, {9, 0, 9}, {9, 0, -9}}, {}}, 1);
    for (int k = 0; k < count; ++k) {
        const double x = -4 + 0.8 * (k % 11), y = 0.4 + 0.3 * (k / 11), z = -2;
        raytree::test::add(
            scene,
            Polygon{{{x, y, z}, {x + 0.5, y, z}, {x + 0.5, y, z + 0.5}, {x, y, z + 0.5}}, {}}, 1);
    }
    return scene;
}

std::uint8_t firmest(const Mesh& mesh) {
    std::uint8_t most = 0;
    for (std::size_t k = 3; k < mesh.colours.size(); k += 4) {
        most = std::max(most, mesh.colours[k]);
    }
    return most;
}

TEST_CASE("app: shadow volumes let the scene be seen, however many there are") {
    for (const int count : {1, 3, 10, 40}) {
        State state;
        state.show(test::opened(squares_over_a_floor(count)));
        state.pick({40, 50});
        state.poll(std::chrono::seconds(10));
        test::run_and_wait(state, "explain.volumes");
        REQUIRE(state.explanation().volumes);
        std::size_t walls = 0;
        for (const ShadowVolume& volume : state.explanation().volumes->volumes) {
            walls += volume.walls.size();
        }
        REQUIRE(walls >= static_cast<std::size_t>(4 * count));
        const ExplainedMesh mesh =
            explained_mesh(state, extent_of(*state.document()), View{.width = 400, .height = 300});
        const double alpha = firmest(mesh.faces);
        CHECK(alpha >= 4);  // and are seen themselves
        // A line of sight through one wall of every three.
        CHECK(std::pow(1 - alpha / 255, static_cast<double>(walls) / 3) > 0.4);
    }
}

TEST_CASE("app: the larger a volume that is looked at, the fainter it is filled") {
    State state;
    state.show(test::opened(squares_over_a_floor(40)));
    state.pick({40, 28});
    state.poll(std::chrono::seconds(10));
    test::run_and_wait(state, "explain.boxes");
    const Extent extent = extent_of(*state.document());
    std::vector<std::pair<double, int>> filled;  // size and firmness
    for (int step = 0; step < 60; ++step) {
        test::run_and_wait(state, "explain.step_forward");
        const ExplainedMesh mesh = explained_mesh(state, extent, View{.width = 400, .height = 300});
        const auto& points = mesh.faces.points;
        if (points.empty()) {
            continue;
        }
        Span3 box{{points[0], points[1], points[2]}, {points[0], points[1], points[2]}};
        for (std::size_t k = 0; k < points.size(); k += 3) {
            box.add({points[k], points[k + 1], points[k + 2]});
        }
        filled.emplace_back(box.diagonal(), firmest(mesh.faces));
    }
    REQUIRE(filled.size() > 5);
    std::ranges::sort(filled);
    CHECK(filled.front().second > filled.back().second);
    for (std::size_t k = 1; k < filled.size(); ++k) {
        CHECK(filled[k].second <= filled[k - 1].second);
        // Sizes that are nearly alike are filled nearly alike.
        if (filled[k].first < 1.05 * filled[k - 1].first) {
            CHECK(filled[k - 1].second - filled[k].second <= 4);
        }
    }
}

}  // namespace
}  // namespace raytree::inspector
