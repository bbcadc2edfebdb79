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
    for (const OverlayKind& kind : overlay->kinds) {
        CHECK(kind.pixels <= overlay->kinds.front().pixels);
        all += kind.pixels;
    }
    CHECK(all == overlay->values.size());
    CHECK(plain_word(Reason::no_intersection) == "no intersection");
    CHECK(overlay->cells.size() == overlay->values.size());
}

TEST_CASE("app: an overlay compares the depth picture with the shadow rays of a light") {
    const auto document = test::document_of(test::glass_ball_scene());
    const std::string light = document->scene().lights.front().name;
    const OverlayRender render(document, lesson::DepthShown{light, 64, 0});
    while (!render.stopped()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    const auto& overlay = render.overlay();
    REQUIRE(overlay);
    CHECK(title_of(*overlay) == "Depth picture beside shadow rays: " + light);
    const DepthAgreement agreed =
        agreement(document->world(), 0, DepthPicture(document->world(), 0, 64), 0);
    const auto pixels = [&](std::string_view name) {
        const auto kind = std::ranges::find(overlay->kinds, name, &OverlayKind::name);
        return kind == overlay->kinds.end() ? 0 : kind->pixels;
    };
    CHECK(agreed.wrongly_dark > 0);  // without a bias there is acne
    CHECK(pixels("wrongly dark") == agreed.wrongly_dark);
    CHECK(pixels("wrongly lit") == agreed.wrongly_lit);
    CHECK(overlay->cells.size() == overlay->values.size());
    const OverlayRender none(document, lesson::DepthShown{"moon", 64, 0});
    while (!none.stopped()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    CHECK(none.failure().find("no light 'moon'") != std::string::npos);
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
    run_command(state, "overlay.depth");  // there is no scene whose light could be compared
    CHECK_FALSE(state.look().depth_overlay);
    state.show(test::opened(test::glass_ball_scene()));
    run_command(state, "overlay.rays");
    run_command(state, "overlay.depth");
    CHECK(find_command("overlay.depth")->on(state));
    CHECK(state.explained().depth);
    CHECK_FALSE(find_command("overlay.rays")->on(state));
    run_command(state, "overlay.tests");
    CHECK_FALSE(find_command("overlay.depth")->on(state));
}

}  // namespace
}  // namespace raytree::inspector
