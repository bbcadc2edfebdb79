// What a hand feels of the inspector, measured: how long after the start there is a window, and the
// scene's first tree in it; from the choice of a pixel, or of a ray, to the frame that shows it;
// and from another view or a whole other scene.
//
// Usage: raytree_inspector_click [SCENE [WIDTH HEIGHT]]   (a display is needed, such as Xvfb's)

#include <QWindow>
#include <chrono>
#include <future>

#include "folders.h"
#include "inspector/hand.h"
#include "tree/record.h"

namespace raytree::inspector::bench {
namespace {

constexpr int depth = 6;

std::vector<Pixel> pixels_of(const Camera& camera) {
    std::vector<Pixel> pixels;
    for (int k = 0; k < 60; ++k) {
        pixels.push_back({camera.width * (20 + 3 * (k * 7 % 20)) / 100,
                          camera.height * (20 + 3 * (k * 11 % 20)) / 100});
    }
    return pixels;
}

void measure_clicks(State& state, ScenePane& pane) {
    std::vector<Time> trees, picks, rays, views;
    for (const Pixel pixel : pixels_of(state.document()->scene().camera)) {
        const Stopwatch watch;
        const auto tree = record_tree(state.document()->world(), pixel.i, pixel.j);
        trees.push_back(watch.read());
        picks.push_back(time_of(state, pane, [&] { state.pick(pixel); }));
        if (state.tree() && tree.rays.size() > 1) {
            rays.push_back(time_of(state, pane, [&] { state.select(tree.rays.size() / 2); }));
        }
    }
    for (int k = 0; k < 20; ++k) {
        const Request request = k % 2 ? Request::from_side : Request::through_camera;
        views.push_back(time_of(state, pane, [&] { state.request(request); }));
    }
    print("computing a tree", trees);
    print("click to drawn tree", picks);
    if (!rays.empty()) {
        print("choice of a ray to drawn choice", rays);
    }
    print("another view to drawn view", views);
}

/// The scene with one number changed, as a slider does it.
Opened changed(const Opened& opened, double share) {
    LoadedScene loaded = opened.document->loaded();
    for (Light& light : loaded.scene.lights) {
        light.intensity = (0.5 + share) * light.intensity;
    }
    return {
        std::make_shared<Document>(opened.document->file(), std::move(loaded)), opened.pixel, {}};
}

void measure_changes(State& state, ScenePane& pane, Opened opened) {
    opened.pixel = state.pixel();
    std::vector<Time> changes;
    for (int k = 0; k < 20; ++k) {
        changes.push_back(time_of(state, pane, [&] { state.show(changed(opened, k / 20.0)); }));
    }
    print("another scene to drawn tree", changes);
}

Opened with_depth(const Opened& opened) {
    LoadedScene loaded = opened.document->loaded();
    loaded.scene.settings.max_depth = depth;
    return {
        std::make_shared<Document>(opened.document->file(), std::move(loaded)), std::nullopt, {}};
}

void run(const char* file, int width, int height, int argc, char** argv, const Stopwatch& start) {
    auto reading = std::async(std::launch::async,  // beside the window, as the program does
                              [&] { return with_depth(open_file(file)); });
    ShownWindow shown(argc, argv, width, height);
    State& state = shown.state;
    ScenePane& pane = shown.window.scene_pane();
    process_while([&] { return !shown.window.windowHandle()->isExposed(); });
    QApplication::processEvents();
    const Time on_the_screen = start.read();
    process_while(
        [&] { return reading.wait_for(std::chrono::seconds(0)) != std::future_status::ready; });
    const Opened opened = reading.get();
    time_of(state, pane, [&] { state.show(opened); });
    const Time drawn = start.read();
    std::printf("%s, %zu objects, depth %d, window %dx%d\n", file,
                opened.document->scene().objects.size(), depth, width, height);
    print_heading("milliseconds (of the processor)");
    print("start to window on the screen", {on_the_screen});
    print("start to first drawn tree", {drawn});
    wait_for_picture(state, shown.window);
    measure_clicks(state, pane);
    measure_changes(state, pane, opened);
}

}  // namespace
}  // namespace raytree::inspector::bench

int main(int argc, char** argv) {
    using namespace raytree::inspector::bench;
    const Stopwatch start;
    const char* const file = argc > 1 ? argv[1] : RAYTREE_DATA_DIR "/scenes/sphereflake.json";
    const bool size = argc > 3;
    return exit_code_of([&] {
        run(file, size ? atoi(argv[2]) : 1280, size ? atoi(argv[3]) : 800, argc, argv, start);
    });
}
