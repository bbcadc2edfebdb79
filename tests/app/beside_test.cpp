// What is shown beside a pixel's tree: the error bounds of its numbers, and its neighbours' trees.

#include <doctest/doctest.h>

#include <algorithm>

#include "app/scenes.h"
#include "state/bounds_details.h"
#include "state/commands.h"
#include "state/marked_texts.h"
#include "state/neighbours.h"

namespace raytree::inspector {
namespace {

State shown_scene() {
    State state;
    state.show(test::opened(test::glass_ball_scene()));
    state.pick({40, 30});
    state.poll(std::chrono::seconds(10));
    REQUIRE(state.tree());
    return state;
}

void run(State& state, const char* command) {
    run_command(state, command, "");
    state.poll(std::chrono::seconds(10));
    REQUIRE(state.tree());
}

/// The values of the row after that of `label`, if it is one of bounds.
std::vector<double> bounds_below(const std::vector<DetailSection>& sections,
                                 const std::string& label) {
    for (const DetailSection& section : sections) {
        for (std::size_t k = 0; k + 1 < section.rows.size(); ++k) {
            if (section.rows[k].label == label && section.rows[k + 1].label == "   ±") {
                return section.rows[k + 1].values;
            }
        }
    }
    return {};
}

TEST_CASE("app: neighbours are the pixels around that lie in the picture") {
    Camera camera;
    camera.width = 10;
    camera.height = 8;
    const auto count = [&](Pixel pixel, Neighbours which) {
        const auto found = neighbours_of(pixel, which, camera);
        CHECK(std::ranges::count(found, pixel) == 0);
        return found.size();
    };
    CHECK(count({5, 4}, Neighbours::square) == 8);
    CHECK(count({0, 0}, Neighbours::square) == 3);
    CHECK(count({9, 4}, Neighbours::square) == 5);
    CHECK(count({5, 4}, Neighbours::row) == 8);
    CHECK(count({1, 4}, Neighbours::row) == 5);
    CHECK(count({5, 7}, Neighbours::column) == 4);
    CHECK(count({5, 4}, Neighbours::none) == 0);
}

TEST_CASE("app: neighbours' trees are those of the pixels themselves, and the chosen one stays") {
    State state = shown_scene();
    state.select(state.tree()->tree.rays.size() - 1);
    const auto chosen = state.selected()->id;
    run(state, "neighbours.square");
    CHECK(state.selected()->id == chosen);
    REQUIRE(state.tree()->neighbours.size() == 8);
    const RayTree<double> first = state.tree()->neighbours[0]->tree;
    CHECK(first.pixel_i == 39);
    CHECK(first.pixel_j == 29);
    run(state, "neighbours.square");
    CHECK(state.tree()->neighbours.empty());
    state.pick({39, 29});
    state.poll(std::chrono::seconds(10));
    REQUIRE(state.tree());
    CHECK(state.tree()->tree.rays.size() == first.rays.size());
    CHECK(state.tree()->tree.intensity == first.intensity);
}

TEST_CASE("app: error bounds stand beside the numbers when they are asked for") {
    State state = shown_scene();
    CHECK(!state.tree()->bounds);
    CHECK(bounds_below(known_details(*state.tree(), 0, state.playback()), "point").empty());
    run(state, "show.bounds");
    REQUIRE(state.tree()->bounds);
    REQUIRE(state.tree()->bounds->size() == state.tree()->tree.rays.size());
    const auto sections = known_details(*state.tree(), 0, state.playback());
    const auto point = bounds_below(sections, "point");
    REQUIRE(point.size() == 1);
    CHECK(point[0] > 0);
    CHECK(point[0] < 1e-12);
    CHECK(bounds_below(sections, "= intensity").size() == 3);
    for (const DetailSection& section : sections) {  // what is exact has none
        for (const DetailRow& row : section.rows) {
            CHECK((row.label != "   ±" ||
                   std::ranges::any_of(row.values, [](double bound) { return bound > 0; })));
        }
    }
    const auto whole = std::ranges::find(sections, "Hit", &DetailSection::title);
    REQUIRE(whole != sections.end());
    const auto row = std::ranges::find(whole->rows, "t", &DetailRow::label);
    REQUIRE(row != whole->rows.end());
    REQUIRE(row->cells.size() == 2);
    CHECK(row->cells[1].starts_with("± "));
    CHECK(row->cells[1].find("e-1") != std::string::npos);
    CHECK(!in_doubt(*state.tree(), 0));
    run(state, "show.bounds");
    CHECK(!state.tree()->bounds);
}

TEST_CASE("app: a bound far below the rounding of the intensity is not shown") {
    State state = shown_scene();
    run(state, "show.bounds");
    PixelTree tree = *state.tree();
    std::vector<RayBounds> bounds = *tree.bounds;
    bounds[0].specular = Rgb<double>(4e-151);
    bounds[0].diffuse = Rgb<double>(1e-3);
    tree.bounds = std::make_shared<const std::vector<RayBounds>>(bounds);
    const auto sections = known_details(tree, 0, state.playback());
    CHECK(bounds_below(sections, "+ specular").empty());
    CHECK(bounds_below(sections, "+ diffuse").size() == 3);
}

}  // namespace
}  // namespace raytree::inspector
