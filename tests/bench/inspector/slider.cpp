// How often a second the inspector shows what it changes while a slider is dragged, measured on
// every scene of every lesson: the light's intensity, the depth, and a surface's colour, which has
// shapes drawn anew too.
//
// Usage: raytree_inspector_slider [--quick] [LESSON...]   (a display is needed, such as Xvfb's)
//
// With --quick, few changes of each lesson's first scene, and a failure where one is not shown.

#include <cstring>
#include <set>

#include "inspector/hand.h"
#include "lesson/lesson_folder.h"
#include "state/commands.h"

namespace raytree::inspector::bench {
namespace {

/// A slider's way: a place, and its values from a share of 0 to 1.
struct Way {
    std::string place;
    double from, to;
};

std::vector<Way> ways_in(const Scene& scene) {
    std::vector<Way> ways;
    if (!scene.lights.empty()) {
        ways.push_back({"/lights/0/intensity", 0.5, 1.5});
    }
    for (const Knob& knob : knobs_of(scene, {KnobOwner::Kind::material, 0})) {
        if (knob.label == "kd") {
            ways.push_back({knob.place, 0.1, 0.9});
        }
    }
    ways.push_back({"/settings/min_weight", 0, 0.01});
    return ways;
}

std::vector<Time> drag(State& state, ScenePane& pane, const Way& way, int count) {
    std::vector<Time> times;
    for (int k = 0; k < count; ++k) {
        const double value = way.from + (way.to - way.from) * (k + 0.5) / count;
        times.push_back(time_of(state, pane, [&] {
            run_command(state, "change.drag", way.place + " " + std::to_string(value));
        }));
    }
    state.let_go();
    return times;
}

/// Milliseconds of all changes in a lesson.
std::vector<Time> measure(const std::string& name, State& state, MainWindow& window, int count,
                          bool first_alone) {
    state.open_lesson(lesson::load_lesson(lesson::own_lessons(), name));
    std::set<const Document*> seen;
    std::vector<Time> times;
    for (std::size_t step = 0; step < state.lesson()->count(); ++step) {
        state.go_to_lesson_step(step);
        wait_for_picture(state, window);
        if (!seen.insert(state.document().get()).second) {
            continue;
        }
        for (const Way& way : ways_in(state.document()->scene())) {
            const std::vector<Time> more = drag(state, window.scene_pane(), way, count);
            times.insert(times.end(), more.begin(), more.end());
        }
        if (first_alone) {
            break;
        }
    }
    return times;
}

void run(std::vector<std::string> lessons, bool quick, int argc, char** argv) {
    ShownWindow shown(argc, argv);
    if (lessons.empty()) {
        lessons = lesson::lesson_names(lesson::own_lessons());
    }
    print_heading("change to drawn change, ms");
    std::vector<Time> all;
    for (const std::string& name : lessons) {
        const std::vector<Time> times =
            measure(name, shown.state, shown.window, quick ? 2 : 8, quick);
        print(name, times);
        all.insert(all.end(), times.begin(), times.end());
    }
    print("all lessons", all);
    const auto rate = [&](double Time::*which) { return 1e3 / median_and_worst(all, which).first; };
    const auto slow = std::ranges::count_if(all, [](const Time& t) { return t.process > 100; });
    std::printf("%-34s %8.1f (%8.1f) a second; %zd of %zu changes over 100 ms of the processor\n",
                "frames while dragging", rate(&Time::clock), rate(&Time::process),
                static_cast<std::ptrdiff_t>(slow), all.size());
}

}  // namespace
}  // namespace raytree::inspector::bench

int main(int argc, char** argv) {
    std::vector<std::string> lessons(argv + 1, argv + argc);
    const bool quick = std::erase(lessons, "--quick") > 0;
    using namespace raytree::inspector::bench;
    return exit_code_of([&] { run(lessons, quick, argc, argv); });
}
