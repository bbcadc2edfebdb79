// What the diagram and the counts of a tree show.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "app/scenes.h"
#include "state/commands.h"
#include "state/counts.h"
#include "state/diagram.h"
#include "state/folding.h"
#include "support/scenes.h"

namespace raytree::inspector {
namespace {

State shown(Scene scene, Pixel pixel = {40, 30}) {
    State state;
    state.show(test::opened(std::move(scene)));
    state.pick(pixel);
    state.poll(std::chrono::seconds(10));
    REQUIRE(state.tree());
    return state;
}

TEST_CASE("app: every ray is found in the diagram where it is drawn") {
    const State state = shown(test::glass_ball_scene());
    const PixelTree& tree = *state.tree();
    const Diagram diagram = diagram_of(tree.tree);
    for (const TreeRay<double>& ray : tree.tree.rays) {
        const DiagramSpot spot = spot_of(diagram, tree, ray.id);
        CHECK(ray_of(diagram, spot) == ray.id);
        CHECK(spot.light.has_value() == ray.shadow.has_value());
        const DiagramPlace place = place_of(diagram, spot);
        const auto found = spot_at(diagram, place.x + place.width / 2, place.y + place.height / 2);
        REQUIRE(found);
        CHECK(ray_of(diagram, *found) == ray.id);
    }
    CHECK_FALSE(spot_at(diagram, -5, -5));
}

TEST_CASE("app: a folded diagram has fewer boxes and still every ray") {
    const State state = shown(test::glass_ball_scene());
    const PixelTree& tree = *state.tree();
    const Diagram whole = diagram_of(tree.tree);
    const Diagram folded = diagram_of(tree.tree, 0.3);
    CHECK(folded.boxes.size() < whole.boxes.size());
    std::size_t rays = 0;
    for (const DiagramBox& box : folded.boxes) {
        rays += box.folded;
        if (!box.absent && box.folded == 0) {
            ++rays;
            for (const LightRow& light : box.lights) {
                rays += light.ray ? 1 : 0;
            }
        }
    }
    CHECK(rays == tree.tree.rays.size());
    for (const TreeRay<double>& ray : tree.tree.rays) {
        CHECK(ray_of(folded, spot_of(folded, tree, ray.id)) <= ray.id);
    }
}

TEST_CASE("app: the diagram is folded and unfolded in steps, and wholly at the end") {
    State state = shown(test::glass_ball_scene());
    run_command(state, "diagram.fold_more");
    CHECK_FALSE(state.tree_pane().fold_below);  // the diagram is not shown
    run_command(state, "tab.diagram");
    CHECK_FALSE(fold_less(*state.tree(), 0));
    std::size_t boxes = diagram_of(state.tree()->tree).boxes.size();
    while (fold_more(*state.tree(), fold_of(*state.tree(), state.tree_pane()))) {
        run_command(state, "diagram.fold_more");
        const std::size_t fewer =
            diagram_of(state.tree()->tree, *state.tree_pane().fold_below).boxes.size();
        CHECK(fewer <= boxes);
        boxes = fewer;
    }
    CHECK(boxes <= 3);
    while (fold_less(*state.tree(), fold_of(*state.tree(), state.tree_pane()))) {
        run_command(state, "diagram.fold_less");
    }
    CHECK(state.tree_pane().fold_below == 0);
}

TEST_CASE("app: a diagram that is too wide for its room opens folded, and unfolds on demand") {
    State state = shown(test::glass_ball_scene());
    const double whole = diagram_of(state.tree()->tree).width;
    TreePane pane = state.tree_pane();
    pane.tab = TreePane::Tab::diagram;
    pane.room = 2 * whole;
    CHECK(fold_of(*state.tree(), pane) == 0);
    pane.room = 0.8 * whole;
    const double fold = fold_of(*state.tree(), pane);
    CHECK(fold > 0);
    CHECK(diagram_of(state.tree()->tree, fold).width <= pane.room);
    // One step less would not fit.
    CHECK(diagram_of(state.tree()->tree, fold_less(*state.tree(), fold).value()).width > pane.room);
    pane.room = 1;
    CHECK(std::isfinite(fold_of(*state.tree(), pane)));
    pane.room = 0.8 * whole;
    state.change_tree_pane(pane);
    while (fold_less(*state.tree(), fold_of(*state.tree(), state.tree_pane()))) {
        run_command(state, "diagram.fold_less");
    }
    CHECK(state.tree_pane().fold_below == 0);
}

/// Rays and folded branches: what is not sent has a box of its own as well.
std::ptrdiff_t ray_boxes(const PixelTree& tree, double fold) {
    return std::ranges::count(diagram_of(tree.tree, fold).boxes, false, &DiagramBox::absent);
}

TEST_CASE("app: as much of a diagram is unfolded as has room, whatever the shares of its rays") {
    Scene scene = test::glass_ball_scene();
    scene.settings.max_depth = 9;
    scene.settings.min_weight = 0;
    scene.materials.front().kr = Colour(0.37);
    scene.materials.front().kt = Colour(0.61);
    const State state = shown(std::move(scene));
    const PixelTree& tree = *state.tree();
    std::set<double> shares;
    for (const TreeRay<double>& ray : tree.tree.rays) {
        shares.insert(largest_component(ray.weight));
    }
    REQUIRE(shares.size() > 6);
    const double whole = diagram_of(tree.tree).width;
    for (const double part : {0.25, 0.4, 0.6, 0.9}) {
        TreePane pane;
        pane.room = part * whole;
        const double fold = fold_of(tree, pane);
        CHECK(diagram_of(tree.tree, fold).width <= pane.room);
        const auto lighter = std::ranges::find_if(shares.rbegin(), shares.rend(),
                                                  [&](double share) { return share < fold; });
        REQUIRE(lighter != shares.rend());
        CHECK(diagram_of(tree.tree, *lighter).width > pane.room);
    }
}

TEST_CASE("app: each step of folding is worth taking, and goes back") {
    Scene scene = test::glass_ball_scene();
    scene.settings.max_depth = 9;
    scene.settings.min_weight = 0;
    const State state = shown(std::move(scene));
    const PixelTree& tree = *state.tree();
    std::optional<double> fold = 0;
    std::vector<std::ptrdiff_t> boxes;
    for (; fold; fold = fold_more(tree, *fold)) {
        boxes.push_back(ray_boxes(tree, *fold));
        if (const auto less = fold_less(tree, *fold); less && *fold > 0) {
            CHECK(ray_boxes(tree, *less) > boxes.back());
        }
    }
    REQUIRE(boxes.size() > 3);
    CHECK(boxes.back() <= 3);  // the root and its folded branches
    for (std::size_t k = 1; k < boxes.size(); ++k) {
        CHECK(boxes[k] < boxes[k - 1]);
        if (k + 1 < boxes.size()) {
            CHECK(4 * boxes[k] <= 3 * boxes[k - 1]);
        }
    }
}

TEST_CASE("app: branches of one share are folded together") {
    // Reflected and refracted rays weigh alike on every level.
    Scene scene = test::deep_scene();
    scene.settings.max_depth = 5;
    const State state = shown(std::move(scene), {3, 2});
    const PixelTree& tree = *state.tree();
    const double all = largest_component(tree.tree.rays[1].weight);
    for (double fold = 0; fold_more(tree, fold); fold = *fold_more(tree, fold)) {
        for (const TreeRay<double>& ray : tree.tree.rays) {
            const double share = largest_component(ray.weight);
            const bool on_the_edge = fold > 0 && std::abs(share - fold) < 1e-9 * all;
            CHECK_FALSE((on_the_edge && share < fold));
        }
    }
}

TEST_CASE("app: a tree with very many rays is folded by itself") {
    Scene scene = test::glass_ball_scene();
    scene.settings.max_depth = 24;
    scene.settings.min_weight = 0;
    scene.materials.front().kr = scene.materials.front().kt = Colour(0.6);
    scene.materials.front().ior = 1;
    for (const double z : {2.0, 2.5, 3.0, 3.5, 4.0}) {
        raytree::test::add(scene, Polygon{{{-9, -9, z}, {9, -9, z}, {9, 9, z}, {-9, 9, z}}, {}}, 0);
    }
    scene.settings.ray_budget = 20000;
    const State state = shown(scene);
    const double fold = fold_of(*state.tree(), 0);
    CHECK(fold > 0);
    CHECK(diagram_of(state.tree()->tree, fold).boxes.size() < 4000);
    CHECK_FALSE(fold_less(*state.tree(), 0));
}

TEST_CASE("app: the counts add up") {
    const State state = shown(test::glass_ball_scene());
    const RayTree<double>& tree = state.tree()->tree;
    const TreeStatistics all = statistics_of(*state.document(), *state.tree());
    std::size_t rays = 0;
    double full = 0;
    for (const TreeStatistics::Kind& kind : all.kinds) {
        rays += kind.count;
        full += kind.full;
        CHECK(static_cast<double>(kind.count) <= kind.full);
    }
    CHECK(rays == tree.rays.size());
    CHECK(full == (2 + 1) * (std::exp2(4) - 1));
    CHECK(all.shapes == 3);
    CHECK(all.all_tests == 3.0 * static_cast<double>(rays));
    for (std::size_t k = 1; k < all.not_sent.size(); ++k) {
        CHECK(all.not_sent[k - 1].count >= all.not_sent[k].count);
    }
}

TEST_CASE("app: light is lost to the depth limit and to the weight limit") {
    Scene scene = test::glass_ball_scene();
    scene.settings.max_depth = 1;
    State state = shown(scene);
    TreeStatistics all = statistics_of(*state.document(), *state.tree());
    CHECK(all.to_depth.branches == 2);
    REQUIRE(all.to_depth.weight);
    CHECK(all.to_depth.weight->r == doctest::Approx(0.1 + 0.8));
    CHECK(all.to_weight.branches == 0);

    scene.settings.max_depth = 2;
    scene.settings.min_weight = 0.5;
    state = shown(scene);
    all = statistics_of(*state.document(), *state.tree());
    CHECK(all.to_weight.branches == 1);
    CHECK(all.to_weight.weight->g == doctest::Approx(0.1));
}

}  // namespace
}  // namespace raytree::inspector
