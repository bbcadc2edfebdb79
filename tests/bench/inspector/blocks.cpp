// For how long at most the inspector's window answers nothing while large scenes are opened, their
// pixels chosen, their values changed, and features explained.
//
// Usage: raytree_inspector_blocks [SCENE...]   (a display is needed, such as Xvfb's)
//
// Without scenes: the sphereflake, and a terrain of 10^6 triangles as an OBJ file. The processor's
// time, in brackets, is that of the window's thread.

#include "folders.h"
#include "inspector/hand.h"
#include "state/commands.h"
#include "support/generate.h"
#include "support/scene_files.h"

namespace raytree::inspector::bench {
namespace {

class Measuring {
  public:
    explicit Measuring(State& state) : state_(state) {}

    template <class Act> void measure(const std::string& what, Act act) {
        heart_.begin();
        const Stopwatch watch;
        act();
        do {
            process_for(150);
        } while (state_.working());
        const Time longest = heart_.longest();
        std::printf("    %-30s %8.1f (%8.1f) ms   of %8.0f\n", what.c_str(), longest.clock,
                    longest.process, watch.read().clock);
        std::fflush(stdout);
    }
    void command(const std::string& id, const std::string& argument = {}) {
        measure(id + " " + argument, [&] { run_command(state_, id, argument); });
    }

  private:
    State& state_;
    Heartbeat heart_;
};

void go_through(const std::string& file, State& state, MainWindow& window) {
    Measuring blocked(state);
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
    blocked.command("explain.boxes");
    blocked.command("explain.nothing");
    blocked.command("explain.shower");
    blocked.command("explain.nothing");
    blocked.command("explain.depth");
    blocked.command("explain.nothing");
}

void run(std::vector<std::string> files, int argc, char** argv) {
    ShownWindow shown(argc, argv);
    process_for(500);
    const raytree::bench::TemporaryFolder folder;
    if (files.empty()) {
        const std::string terrain = raytree::bench::write_scene_files(
            raytree::bench::generate("terrain", 1'000'000), folder);
        files = {RAYTREE_DATA_DIR "/scenes/sphereflake.json", terrain};
    }
    std::printf("longest time without an answer, by the clock (of the window's thread)\n");
    for (const std::string& file : files) {
        go_through(file, shown.state, shown.window);
    }
}

}  // namespace
}  // namespace raytree::inspector::bench

int main(int argc, char** argv) {
    raytree::inspector::bench::run({argv + 1, argv + argc}, argc, argv);
}
