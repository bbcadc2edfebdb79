#include "state/right_of_way.h"

#include <doctest/doctest.h>

#include <chrono>
#include <thread>

#include "scenes.h"
#include "state/overlay.h"
#include "state/picture.h"

namespace raytree::inspector {
namespace {

using namespace std::chrono_literals;

std::shared_ptr<const Document> small_document() {
    Scene scene = test::glass_ball_scene();
    scene.camera.width = 32;
    scene.camera.height = 20;
    return test::document_of(scene);
}

TEST_CASE("while the window draws, its picture stands still; then it is completed") {
    RightOfWay window(1h);
    window.take();
    PictureRender render(small_document(), nullptr, &window);
    std::this_thread::sleep_for(50ms);
    CHECK(render.version() == 0);
    CHECK_FALSE(render.stopped());
    window.leave();
    while (!render.stopped()) {
        std::this_thread::sleep_for(1ms);
    }
    CHECK(render.done());
}

TEST_CASE("the picture waits for the window and for the drawing of its view") {
    RightOfWay way(1h);
    way.take(RightOfWay::drawing);
    way.take(RightOfWay::window);
    way.leave(RightOfWay::window);
    PictureRender render(small_document(), nullptr, &way);
    std::this_thread::sleep_for(50ms);
    CHECK(render.version() == 0);
    way.leave(RightOfWay::drawing);
    while (!render.stopped()) {
        std::this_thread::sleep_for(1ms);
    }
    CHECK(render.done());
}

TEST_CASE("beside a window that never rests, picture and overlay come all the same") {
    RightOfWay window(10ms);
    window.take();
    const PictureRender picture(small_document(), nullptr, &window);
    const OverlayRender overlay(small_document(), Measure::rays, &window);
    while (!picture.stopped() || !overlay.stopped()) {
        window.take();
        std::this_thread::sleep_for(1ms);
    }
    CHECK(picture.done());
    CHECK(overlay.overlay());
}

TEST_CASE("what is cancelled ends once the window rests") {
    RightOfWay window(1h);
    window.take();
    PictureRender render(small_document(), nullptr, &window);
    render.cancel();
    window.leave();
    while (!render.stopped()) {
        std::this_thread::sleep_for(1ms);
    }
    CHECK_FALSE(render.done());
}

}  // namespace
}  // namespace raytree::inspector
