#include "state/history.h"

#include <doctest/doctest.h>

#include "app/scenes.h"
#include "state/commands.h"

namespace raytree::inspector {
namespace {

State state_with(std::initializer_list<Pixel> picked) {
    State state;
    state.show({test::document_of(test::glass_ball_scene()), Pixel{0, 0}, {}});
    for (const Pixel pixel : picked) {
        state.pick(pixel);
    }
    return state;
}

TEST_CASE("app: back and forward go through the pixels picked, and no further") {
    State state = state_with({{10, 10}, {20, 20}});
    CHECK_FALSE(find_command("pixel.forward")->possible(state));
    run_command(state, "pixel.back");
    CHECK(state.pixel() == Pixel{10, 10});
    CHECK(state.tree()->tree.pixel_i == 10);
    run_command(state, "pixel.back");
    CHECK(state.pixel() == Pixel{0, 0});
    CHECK_FALSE(find_command("pixel.back")->possible(state));
    run_command(state, "pixel.back");  // stays
    CHECK(state.pixel() == Pixel{0, 0});
    run_command(state, "pixel.forward");
    run_command(state, "pixel.forward");
    CHECK(state.pixel() == Pixel{20, 20});
}

TEST_CASE("app: a pixel picked after going back takes the place of the later ones") {
    State state = state_with({{10, 10}, {20, 20}});
    run_command(state, "pixel.back");
    state.pick({30, 30});
    CHECK_FALSE(find_command("pixel.forward")->possible(state));
    run_command(state, "pixel.back");
    CHECK(state.pixel() == Pixel{10, 10});
}

TEST_CASE("app: the pixels of a drag or of arrow keys are one entry, the last") {
    State state = state_with({{10, 10}});
    for (int k = 0; k < 5; ++k) {
        run_command(state, "pixel.right");
    }
    CHECK(state.pixel() == Pixel{15, 10});
    CHECK(state.history().size() == 3);
    run_command(state, "pixel.back");
    CHECK(state.pixel() == Pixel{10, 10});
    run_command(state, "pixel.forward");
    CHECK(state.pixel() == Pixel{15, 10});
    run_command(state, "pixel.right");  // another way
    CHECK(state.history().size() == 4);
}

TEST_CASE("app: the same pixel again is no entry, and another scene begins anew") {
    State state = state_with({{10, 10}, {10, 10}});
    CHECK(state.history().size() == 2);
    state.show(test::opened(test::glass_ball_scene()));
    CHECK(state.history().size() == 1);
    CHECK_FALSE(find_command("pixel.back")->possible(state));
}

}  // namespace
}  // namespace raytree::inspector
