// For how long at most the inspector's window answers nothing while large scenes are opened, their
// pixels chosen, their values changed, and features explained.
//
// Usage: raytree_inspector_blocks [SCENE...]   (a display is needed, such as Xvfb's)
//
// Without scenes: the sphereflake, a terrain of 10^6 triangles as an OBJ file, and all lessons,
// step by step. The processor's time, in brackets, is that of the window's thread. What is asked
// for is shown some time after the window has answered: the last columns say how many frames of the
// 3D view were drawn until everything was shown, and within how many milliseconds.

#include <QMouseEvent>

#include "folders.h"
#include "inspector/hand.h"
#include "lesson/lesson_folder.h"
#include "state/commands.h"
#include "support/generate.h"
#include "support/scene_files.h"

namespace raytree::inspector::bench {
namespace {

class Measuring {
  public:
    Measuring(State& state, const ScenePane& pane) : state_(state), pane_(pane) {}

    template <class Act> void measure(const std::string& what, Act act) {
        heart_.begin();
        const int frames = pane_.frames();
        const Stopwatch watch;
        act();
        process_for(5);
        process_while([&] { return state_.working() || !pane_.has_shapes(); });
        const double shown = watch.read().clock;
        process_for(150);
        const Time longest = heart_.longest();
        std::printf("    %-30s %8.1f (%8.1f) ms   %4d frames in %8.0f\n", what.c_str(),
                    longest.clock, longest.process, pane_.frames() - frames, shown);
        std::fflush(stdout);
    }
    void command(const std::string& id, const std::string& argument = {}) {
        measure(id + " " + argument, [&] { run_command(state_, id, argument); });
    }

  private:
    State& state_;
    const ScenePane& pane_;
    Heartbeat heart_;
};

void send_mouse(QWidget& widget, QEvent::Type type, QPoint at) {
    const bool moves = type == QEvent::MouseMove;
    QMouseEvent event(type, at, moves ? Qt::NoButton : Qt::LeftButton,
                      type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, {});
    QApplication::sendEvent(&widget, &event);
}

/// The 3D view turned by a hand, a few frames a second faster than it follows.
void turn(ScenePane& pane) {
    QWidget& canvas = *pane.focusProxy();
    const QPoint from = canvas.rect().center();
    send_mouse(canvas, QEvent::MouseButtonPress, from);
    for (int k = 1; k <= 20; ++k) {
        send_mouse(canvas, QEvent::MouseMove, from + QPoint(6 * k, 2 * k));
        process_for(30);
    }
    send_mouse(canvas, QEvent::MouseButtonRelease, from + QPoint(120, 40));
}

void go_through(const std::string& file, State& state, MainWindow& window) {
    ScenePane& pane = window.scene_pane();
    Measuring blocked(state, pane);
    std::printf("%s\n", file.c_str());
    blocked.measure("open", [&] { window.open(QString::fromStdString(file)); });
    if (!state.document()) {
        return;
    }
    const Camera& camera = state.document()->scene().camera;
    blocked.measure("picture", [&] { wait_for_picture(state, window); });
    blocked.measure("pick", [&] { state.pick({camera.width / 3, camera.height / 2}); });
    blocked.measure("drag", [&] {
        for (int k = 1; k <= 10; ++k) {
            run_command(state, "change.drag", "/lights/0/intensity 0." + std::to_string(80 + k));
            process_for(40);
        }
        state.let_go();
    });
    blocked.command("change.undo");
    blocked.command("change.set", "/settings/max_depth 3");
    blocked.command("change.reset");
    blocked.command("view.side");
    blocked.command("view.camera");
    blocked.command("view.side");
    blocked.measure("turn", [&] { turn(pane); });
    blocked.command("shapes.wire");
    blocked.measure("turn wires", [&] { turn(pane); });
    blocked.command("shapes.solid");
    blocked.measure("turn solid shapes", [&] { turn(pane); });
    blocked.command("shapes.see_through");
    blocked.command("explain.boxes");
    blocked.command("explain.nothing");
    blocked.command("explain.shower");
    blocked.command("explain.nothing");
    blocked.command("explain.depth");
    blocked.command("explain.nothing");
    blocked.command("look.dark");
    blocked.command("look.dark");
}

/// As a student goes through them, but for the reading.
void go_through_lessons(State& state, MainWindow& window) {
    Measuring blocked(state, window.scene_pane());
    std::printf("lessons\n");
    for (const std::string& name : lesson::lesson_names(lesson::own_lessons())) {
        blocked.measure(name, [&] {
            run_command(state, "lesson.open", name);
            for (std::size_t step = 0; step < state.lesson()->count(); ++step) {
                state.go_to_lesson_step(step);
                process_for(100);
            }
        });
    }
}

void run(std::vector<std::string> files, int argc, char** argv) {
    const raytree::bench::TemporaryFolder folder;
    for (const std::string& file : files) {
        open_file(file);  // throws what the window says in a dialog, which nobody is here to close
    }
    const bool all = files.empty();
    if (all) {
        const std::string terrain = raytree::bench::write_scene_files(
            raytree::bench::generate("terrain", 1'000'000), folder);
        files = {RAYTREE_DATA_DIR "/scenes/sphereflake.json", terrain};
    }
    ShownWindow shown(argc, argv);
    process_for(500);
    std::printf("longest time without an answer, by the clock (of the window's thread)\n");
    for (const std::string& file : files) {
        go_through(file, shown.state, shown.window);
    }
    if (all) {
        go_through_lessons(shown.state, shown.window);
    }
}

}  // namespace
}  // namespace raytree::inspector::bench

int main(int argc, char** argv) {
    using namespace raytree::inspector::bench;
    return exit_code_of([&] { run({argv + 1, argv + argc}, argc, argv); });
}
