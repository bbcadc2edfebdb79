#include <doctest/doctest.h>

#include <set>

#include "app/scenes.h"
#include "state/commands.h"
#include "state/diagram_looks.h"
#include "state/marked_texts.h"

namespace raytree::inspector {
namespace {

State stepping_state() {
    State state;
    state.show(test::opened(test::glass_ball_scene()));
    test::run_and_wait(state, "step.forward");
    return state;
}

std::size_t rows_below(const Outline& outline, std::size_t row) {
    std::size_t count = 1;
    for (const std::size_t child : outline.children_of(row)) {
        count += rows_below(outline, child);
    }
    return count;
}

TEST_CASE("app: stepping begins with the primary ray sent, and shows the steps") {
    State state = stepping_state();
    REQUIRE(state.playback());
    CHECK(state.side_pane() == SidePane::steps);
    CHECK(state.playback()->stop() == 0);
    CHECK(state.selected()->id == 0);
    CHECK(state.playback()->stage(0) == Stage::sent);
    CHECK(state.playback()->stage(1) == Stage::unsent);
}

TEST_CASE("app: forward to the end evaluates every ray once; back undoes it step by step") {
    State state = stepping_state();
    const std::size_t stops = state.playback()->stops();
    std::vector<std::size_t> way = {state.selected()->id};
    for (std::size_t k = 1; k < stops; ++k) {
        test::run_and_wait(state, "step.forward");
        CHECK(state.playback()->stop() == k);
        way.push_back(state.selected()->id);
    }
    CHECK(state.playback()->at_end());
    CHECK_FALSE(find_command("step.forward")->possible(state));
    for (std::size_t ray = 0; ray < state.tree()->tree.rays.size(); ++ray) {
        CHECK(state.playback()->stage(ray) == Stage::evaluated);
    }
    for (std::size_t k = stops - 1; k-- > 0;) {
        test::run_and_wait(state, "step.back");
        CHECK(state.selected()->id == way[k]);
    }
    CHECK_FALSE(find_command("step.back")->possible(state));
}

TEST_CASE("app: first, last and a step's number") {
    State state = stepping_state();
    test::run_and_wait(state, "step.last");
    CHECK(state.playback()->at_end());
    test::run_and_wait(state, "step.first");
    CHECK(state.playback()->stop() == 0);
    test::run_and_wait(state, "step.to", "5");
    CHECK(state.playback()->stop() == 4);
    CHECK_THROWS_AS(run_command(state, "step.to", "0"), InputError);
    CHECK_THROWS_AS(run_command(state, "step.to", "far"), InputError);
    CHECK(state.playback()->stop() == 4);
}

TEST_CASE("app: rays not yet sent are neither in the outline nor in the diagram") {
    State state = stepping_state();
    const auto tree = state.tree();
    const Diagram diagram = diagram_of(tree->tree);
    for (std::size_t k = 0; k < state.playback()->stops(); ++k) {
        state.go_to_stop(k);
        const auto& playback = state.playback();
        std::size_t due = 0;
        for (const TreeRay<double>& ray : tree->tree.rays) {
            due += playback->stage(ray.id) != Stage::unsent;
        }
        const Outline outline(tree, false, happened_rows(playback));
        CHECK(rows_below(outline, 0) == due);
        const auto looks = box_looks(diagram, *tree, playback);
        for (std::size_t box = 0; box < looks.size(); ++box) {
            if (!diagram.boxes[box].absent) {
                const Stage stage = playback->stage(diagram.boxes[box].ray->id);
                CHECK(looks[box].hidden == (stage == Stage::unsent));
                CHECK(looks[box].pending == (stage != Stage::evaluated));
            }
        }
    }
    for (const BoxLook& look : box_looks(diagram, *tree, state.playback())) {
        CHECK_FALSE(look.hidden);
        for (const bool hidden : look.hidden_lights) {
            CHECK_FALSE(hidden);
        }
    }
}

TEST_CASE("app: what is told of the rays while stepping counts those that are sent") {
    State state = stepping_state();
    CHECK(sent_text(*state.playback()) == "1 ray sent so far: 1 primary");
    while (state.playback()->event().kind != TreeEvent::Kind::sent ||
           state.playback()->event().ray != 2) {
        test::run_and_wait(state, "step.forward");
    }
    CHECK(sent_text(*state.playback()).starts_with("3 rays sent so far: 1 primary, "));
}

TEST_CASE("app: an intensity that is not known yet is not shown anywhere") {
    State state = stepping_state();
    test::run_and_wait(state, "step.forward");  // the primary ray's hit is known
    const auto& tree = *state.tree();
    const OutlineTexts texts = marked_texts_of(tree, {0, std::nullopt, 0, 0}, state.playback());
    CHECK(texts.intensity == "…");
    CHECK(texts.met == "ball");
    for (const DetailSection& section : known_details(tree, 0, state.playback())) {
        CHECK(section.title != "Intensity");
    }
    test::run_and_wait(state, "step.last");
    CHECK(marked_texts_of(tree, {0, std::nullopt, 0, 0}, state.playback()).intensity != "…");
    CHECK(known_details(tree, 0, state.playback()).front().title == "Intensity");
}

TEST_CASE("app: while stepping, details say of a ray what has happened to it and no more") {
    State state = stepping_state();
    const auto tree = state.tree();
    const std::set<std::string> of_intensity = {"weight·f·I", "= intensity"};
    const std::set<std::string> of_hit = {"f of t", "t", "point", "object"};
    std::size_t sent = 0, found = 0;
    for (std::size_t k = 0; k < state.playback()->stops(); ++k) {
        state.go_to_stop(k);
        for (const TreeRay<double>& ray : tree->tree.rays) {
            const Stage stage = state.playback()->stage(ray.id);
            if (stage != Stage::sent && stage != Stage::found) {
                continue;
            }
            sent += stage == Stage::sent;
            found += stage == Stage::found;
            CHECK(is_found(state.playback(), ray.id) == (stage == Stage::found));
            for (const DetailSection& section : known_details(*tree, ray.id, state.playback())) {
                for (const DetailRow& row : section.rows) {
                    CHECK_FALSE(of_intensity.contains(row.label));
                    CHECK_FALSE((stage == Stage::sent && of_hit.contains(row.label)));
                }
            }
        }
    }
    CHECK(sent > 0);
    CHECK(found > 0);
}

TEST_CASE("app: the call stack says what each open call waits for and what has come in") {
    State state = stepping_state();
    CHECK(call_texts(*state.playback()).front().waits_for == "its hit");
    std::size_t deepest = 0;
    while (!state.playback()->at_end()) {
        const auto texts = call_texts(*state.playback());
        deepest = std::max(deepest, texts.size());
        for (std::size_t k = 0; k + 1 < texts.size(); ++k) {
            // Each waits for the next one.
            CHECK(texts[k + 1].title.starts_with(texts[k].waits_for));
            CHECK_FALSE(texts[k].sum.empty());
        }
        test::run_and_wait(state, "step.forward");
    }
    CHECK(deepest == 5);  // four levels and a shadow ray
    CHECK(call_texts(*state.playback()).empty());
}

TEST_CASE("app: level by level takes as many steps as there are levels, down and up") {
    State state = stepping_state();
    test::run_and_wait(state, "step.by_levels");
    const int levels = state.tree()->tree.counts.levels;
    CHECK(state.playback()->stops() == static_cast<std::size_t>(3 * levels));
    test::run_and_wait(state, "step.last");
    CHECK(state.playback()->at_end());
}

TEST_CASE("app: playing goes on at each tick and stops at the end") {
    State state = stepping_state();
    test::run_and_wait(state, "step.play");
    CHECK(state.playing());
    state.tick();
    CHECK(state.playback()->stop() == 1);
    for (std::size_t k = 0; k < state.playback()->stops(); ++k) {
        state.tick();
    }
    CHECK(state.playback()->at_end());
    CHECK_FALSE(state.playing());
    test::run_and_wait(state, "step.play");  // from the beginning
    CHECK(state.playback()->stop() == 0);
    test::run_and_wait(state, "step.forward");  // a step by hand
    CHECK_FALSE(state.playing());
}

TEST_CASE("app: the pace doubles and halves within bounds") {
    State state = stepping_state();
    const double pace = state.pace();
    test::run_and_wait(state, "step.faster");
    CHECK(state.pace() == 2 * pace);
    for (int k = 0; k < 20; ++k) {
        test::run_and_wait(state, "step.slower");
    }
    CHECK(state.pace() == 0.25);
}

TEST_CASE("app: the order may be changed while the tree of another pixel is still to come") {
    State state;
    state.show(test::opened(test::deep_scene()));
    state.pick({0, 0});
    state.poll(std::chrono::seconds(60));
    test::run_and_wait(state, "step.last");
    REQUIRE(state.playback());
    state.pick({3, 2});
    state.set_step_order(StepOrder::level_by_level);
    CHECK(state.step_order() == StepOrder::level_by_level);
    state.poll(std::chrono::seconds(60));
    REQUIRE(state.tree());
    REQUIRE(state.playback());
    CHECK(state.playback()->stop() == 0);
    CHECK(state.playback()->stops() ==
          3 * static_cast<std::size_t>(state.tree()->tree.counts.levels));
}

TEST_CASE("app: another pixel is stepped through from its beginning, and ending shows all") {
    State state = stepping_state();
    test::run_and_wait(state, "step.last");
    state.pick({10, 50});
    REQUIRE(state.playback());
    CHECK(state.playback()->stop() == 0);
    test::run_and_wait(state, "step.mode");
    CHECK_FALSE(state.playback());
}

}  // namespace
}  // namespace raytree::inspector
