#include "state/overlay.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>

#include "app/scenes.h"
#include "state/commands.h"
#include "tree/record.h"

namespace raytree::inspector {
namespace {

std::shared_ptr<const Overlay> overlay_of(const std::shared_ptr<const Document>& document,
                                          Measure measure) {
    const OverlayRender render(document, measure);
    while (!render.stopped()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return render.overlay();
}

TEST_CASE("app: an overlay says of each pixel what its tree says") {
    const auto document = test::document_of(test::glass_ball_scene());
    const auto rays = overlay_of(document, Measure::rays);
    REQUIRE(rays);
    for (const Pixel pixel : {Pixel{0, 0}, Pixel{40, 30}, Pixel{79, 59}}) {
        const auto tree = record_tree(document->world(), pixel.i, pixel.j);
        CHECK(rays->at(pixel) == static_cast<double>(tree.counts.all()));
        CHECK(value_text(*rays, pixel) == std::to_string(tree.counts.all()));
    }
    CHECK(rays->range.least == *std::ranges::min_element(rays->values));
    CHECK(rays->range.most == *std::ranges::max_element(rays->values));
}

TEST_CASE("app: an overlay of reasons counts them all, the most frequent first") {
    const auto overlay = overlay_of(test::document_of(test::glass_ball_scene()), Measure::ended);
    REQUIRE(overlay);
    std::size_t all = 0;
    for (const auto& [reason, pixels] : overlay->reasons) {
        CHECK(pixels <= overlay->reasons.front().pixels);
        all += pixels;
    }
    CHECK(all == overlay->values.size());
    CHECK(plain_word(Reason::no_intersection) == "no intersection");
    CHECK(overlay->cells.size() == overlay->values.size());
}

TEST_CASE("app: an overlay that is cancelled is none") {
    OverlayRender render(test::document_of(test::glass_ball_scene()), Measure::tests);
    render.cancel();
    while (!render.stopped()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    CHECK(render.failure().empty());
}

TEST_CASE("app: one overlay is chosen at a time") {
    State state;
    CHECK(find_command("overlay.none")->on(state));
    run_command(state, "overlay.time");
    CHECK(state.look().overlay == Measure::nanoseconds);
    run_command(state, "overlay.rays");
    CHECK(find_command("overlay.rays")->on(state));
    CHECK_FALSE(find_command("overlay.time")->on(state));
    CHECK_FALSE(find_command("overlay.none")->on(state));
    run_command(state, "overlay.none");
    CHECK_FALSE(state.look().overlay);
}

}  // namespace
}  // namespace raytree::inspector
