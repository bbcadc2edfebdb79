// Measures what a hand feels: the time from choosing a pixel, or a ray, to the new tree being on
// the screen. Usage: raytree_click_time SCENE [WIDTH HEIGHT]

#include <QApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <algorithm>
#include <cstdio>
#include <vector>

#include "window/main_window.h"
#include "window/run.h"
#include "window/scene_pane.h"

namespace raytree::inspector {
namespace {

/// Milliseconds until the change that `act` makes has been drawn.
template <class Act> double time_of(const State& state, ScenePane& pane, Act act) {
    QEventLoop loop;
    const int frames = pane.frames();
    QObject::connect(&pane, &ScenePane::drawn, &loop, [&] {
        if (pane.frames() > frames && !state.tracing()) {
            loop.quit();
        }
    });
    QElapsedTimer timer;
    timer.start();
    act();
    loop.exec();
    return static_cast<double>(timer.nsecsElapsed()) / 1e6;
}

void print(const char* what, std::vector<double> times) {
    if (times.empty()) {
        return;
    }
    std::ranges::sort(times);
    std::printf("%-22s median %6.1f ms, worst %6.1f ms of %zu\n", what, times[times.size() / 2],
                times.back(), times.size());
}

void measure(State& state, MainWindow& window) {
    while (!window.feed().done()) {
        QApplication::processEvents(QEventLoop::WaitForMoreEvents, 20);
    }
    QApplication::processEvents();
    ScenePane& pane = window.scene_pane();
    const Camera& camera = state.document()->scene().camera;
    std::vector<double> picks, steps, trees;
    for (int k = 0; k < 40; ++k) {
        const Pixel pixel{camera.width * (20 + 3 * (k * 7 % 20)) / 100,
                          camera.height * (20 + 3 * (k * 11 % 20)) / 100};
        picks.push_back(time_of(state, pane, [&] { state.pick(pixel); }));
        if (state.tree() && state.tree()->tree.rays.size() > 1) {
            const std::size_t ray = state.tree()->tree.rays.size() / 2;
            steps.push_back(time_of(state, pane, [&] { state.select(ray); }));
        }
    }
    print("pixel to drawn tree", picks);
    print("ray to drawn selection", steps);
    std::vector<double> views;
    for (int k = 0; k < 20; ++k) {
        views.push_back(time_of(state, pane, [&] {
            state.request(k % 2 ? Request::from_side : Request::through_camera);
        }));
    }
    print("view to drawn view", views);
}

}  // namespace
}  // namespace raytree::inspector

int main(int argc, char** argv) {
    using namespace raytree::inspector;
    prepare_qt();
    QApplication application(argc, argv);
    State state;
    MainWindow window(state);
    window.resize(argc > 3 ? atoi(argv[2]) : 1280, argc > 3 ? atoi(argv[3]) : 800);
    window.show();
    state.show(open_file(argv[1]));
    measure(state, window);
    return 0;
}
