// What a hand feels of the inspector, measured: how long after the start there is a window; from
// the choice of a pixel, or of a ray, to the frame that shows it; and how many frames a second
// there are while the scene is changed again and again, as by a slider.
//
// Usage: raytree_inspector_click [SCENE [WIDTH HEIGHT]]   (a display is needed, such as Xvfb's)
//
// Times are of the clock and, in brackets, of the process on all of its threads: on a machine with
// other work to do, only the latter say something about the program.

#include <QApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

#include "tree/record.h"
#include "window/main_window.h"
#include "window/run.h"
#include "window/scene_pane.h"

namespace raytree::inspector {
namespace {

constexpr int depth = 6;

struct Time {
    double clock = 0, process = 0;  ///< milliseconds
};

class Stopwatch {
  public:
    Stopwatch() : process_(std::clock()) { timer_.start(); }
    Time read() const {
        return {static_cast<double>(timer_.nsecsElapsed()) / 1e6,
                1e3 * static_cast<double>(std::clock() - process_) / CLOCKS_PER_SEC};
    }

  private:
    QElapsedTimer timer_;
    std::clock_t process_;
};

/// Until the change that `act` makes has been drawn.
template <class Act> Time time_of(const State& state, ScenePane& pane, Act act) {
    QEventLoop loop;
    const int frames = pane.frames();
    QObject::connect(&pane, &ScenePane::drawn, &loop, [&] {
        if (pane.frames() > frames && !state.tracing()) {
            loop.quit();
        }
    });
    const Stopwatch watch;
    act();
    loop.exec();
    return watch.read();
}

std::pair<double, double> median_and_worst(std::vector<Time> times, double Time::*which) {
    std::ranges::sort(times, {}, which);
    return {times[times.size() / 2].*which, times.back().*which};
}

void print(const std::string& what, const std::vector<Time>& times) {
    const auto [median, worst] = median_and_worst(times, &Time::clock);
    const auto [median_process, worst_process] = median_and_worst(times, &Time::process);
    std::printf("%-34s %8.2f (%8.2f) %8.2f (%8.2f)\n", what.c_str(), median, median_process, worst,
                worst_process);
}

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
    print("change of the scene to drawn tree", changes);
    const double median = median_and_worst(changes, &Time::clock).first;
    std::printf("%-34s %8.1f a second\n", "frames while the scene changes", 1000 / median);
}

Opened with_depth(const Opened& opened) {
    LoadedScene loaded = opened.document->loaded();
    loaded.scene.settings.max_depth = depth;
    return {
        std::make_shared<Document>(opened.document->file(), std::move(loaded)), std::nullopt, {}};
}

void run(const char* file, int width, int height, int argc, char** argv, const Stopwatch& start) {
    prepare_qt();
    QApplication application(argc, argv);
    State state;
    MainWindow window(state);
    window.resize(width, height);
    window.show();
    ScenePane& pane = window.scene_pane();
    const Opened opened = with_depth(open_file(file));
    time_of(state, pane, [&] { state.show(opened); });
    std::printf("%s, %zu objects, depth %d, window %dx%d\n", file,
                opened.document->scene().objects.size(), depth, width, height);
    std::printf("%-34s %19s %19s\n", "milliseconds (of the process)", "median", "worst");
    print("start to first window", {start.read()});
    while (!window.feed().done()) {
        QApplication::processEvents(QEventLoop::WaitForMoreEvents, 20);
    }
    QApplication::processEvents();
    measure_clicks(state, pane);
    measure_changes(state, pane, opened);
}

}  // namespace
}  // namespace raytree::inspector

int main(int argc, char** argv) {
    const raytree::inspector::Stopwatch start;
    const char* const file = argc > 1 ? argv[1] : RAYTREE_DATA_DIR "/scenes/sphereflake.json";
    const bool size = argc > 3;
    raytree::inspector::run(file, size ? atoi(argv[2]) : 1280, size ? atoi(argv[3]) : 800, argc,
                            argv, start);
    return 0;
}
