// What takes longer than a window may stand still: how it is handed over, and what becomes of its
// failures.

#include <doctest/doctest.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <new>
#include <stdexcept>
#include <thread>

#include "app/sample_lessons.h"
#include "app/scenes.h"
#include "formats/scene_file.h"
#include "lesson/lesson_folder.h"
#include "scene/progress.h"
#include "state/commands.h"
#include "trace/light_shower.h"

namespace raytree::inspector {
namespace {

using namespace std::chrono_literals;

/// Does the work in another thread and writes down what was said of it, as a window does.
struct Handed {
    State state;
    std::vector<std::string> said;

    Handed() {
        state.show(test::opened(test::glass_ball_scene()));
        state.poll(10s);
        state.set_beside([this](const std::string& doing, const std::function<void()>& work) {
            said.push_back(doing);
            std::exception_ptr thrown;
            CHECK(state.busy());
            std::thread([&] {
                try {
                    work();
                } catch (...) {
                    thrown = std::current_exception();
                }
            }).join();
            state.poll(10s);  // as a timer of the window may
            if (thrown) {
                std::rethrow_exception(thrown);
            }
        });
    }
};

TEST_CASE("app: what is measured and what is written is handed over, and done when it returns") {
    Handed handed;
    State& state = handed.state;
    run_command(state, "explain.time");
    CHECK(state.explained().time.has_value());
    run_command(state, "explain.accuracy");
    CHECK(state.explained().accuracy.has_value());
    CHECK(handed.said.size() == 2);
    namespace fs = std::filesystem;
    const fs::path folder = test::own_path("raytree-long-work-test");
    fs::create_directory(folder);
    const auto file = [&](const char* name) { return (folder / name).string(); };
    run_command(state, "export.tree_json", file("tree.json"));
    run_command(state, "export.scene", file("scene.json"));
    run_command(state, "file.save_as", file("saved.json"));
    CHECK(handed.said.size() == 5);
    CHECK(handed.said.back() == "Writing saved.json");
    for (const char* const name : {"tree.json", "scene.json", "saved.json"}) {
        CHECK(fs::exists(file(name)));
    }
    fs::remove_all(folder);
    CHECK_FALSE(state.busy());
}

TEST_CASE("app: a failure of what was handed over is a failure of the command") {
    Handed handed;
    const auto before = handed.state.document();
    CHECK_THROWS_AS(run_command(handed.state, "file.save_as", "/no/such/folder/scene.json"),
                    InputError);
    CHECK(handed.state.document() == before);
    CHECK_FALSE(handed.state.busy());
}

TEST_CASE("app: while something is handed over nothing of the state changes") {
    Handed handed;
    State& state = handed.state;
    const auto tree = state.tree();
    int told = 0;
    state.observe([&](const Changes&) { ++told; });
    state.do_beside("nothing", [] {});  // polls meanwhile
    CHECK(told == 0);
    CHECK(state.tree() == tree);
    // Work within work is a part of it.
    state.do_beside("outer", [&] { state.do_beside("inner", [] {}); });
    CHECK(handed.said == std::vector<std::string>{"nothing", "outer"});
}

TEST_CASE("app: a lesson's step is prepared in the same way, and shown whole") {
    Handed handed;
    State& state = handed.state;
    const test::Lessons lessons("raytree-long-work-lessons");
    const auto lesson = lesson::load_lesson(lessons.folder, "ball");
    state.open_lesson(lesson, 1);
    CHECK(handed.said == std::vector<std::string>{"Measuring what the step tells"});
    REQUIRE(state.lesson());
    CHECK(state.lesson()->step() == 1);
    CHECK(state.lesson()->page().failure.empty());
    CHECK_FALSE(state.lesson()->page().text.empty());
    state.go_to_lesson_step(lesson->steps.size());  // there is none
    CHECK(state.lesson()->step() == 1);
    state.open_lesson(lesson, lesson->steps.size());  // then the first
    CHECK(state.lesson()->step() == 0);
    CHECK_FALSE(state.lesson()->page().text.empty());
}

/// A lesson of one step, which shows a deep tree.
struct DeepLesson {
    test::Lessons lessons{"raytree-deep-lessons"};

    DeepLesson() {
        save_scene(test::deep_scene(), lessons.folder / "01-ball" / "ball.json");
        std::ofstream(lessons.folder / "01-ball" / "lesson.json") << R"({
          "format": "raytree-lesson/1.0", "title": "Deep", "topic": "Depth", "minutes": 1,
          "steps": [{"title": "Deep", "text": ["Many rays."],
                     "show": {"scene": "ball.json", "pixel": [3, 2], "ray": "2"}}]
        })";
    }
};

TEST_CASE("app: the tree of a lesson's step is waited for beside the window as well") {
    Handed handed;
    State& state = handed.state;
    const DeepLesson deep;
    run_command(state, "show.bounds");  // takes longer yet
    state.poll(20s);
    std::vector<Changes> told;
    state.observe([&](const Changes& changes) { told.push_back(changes); });
    state.open_lesson(lesson::load_lesson(deep.lessons.folder, "ball"));
    CHECK(handed.said.back() == "Tracing the tree of pixel 3,2");
    REQUIRE(state.tree());
    CHECK(state.tree()->tree.rays.size() > 20'000);
    CHECK(state.selected()->id == 2);
    REQUIRE(told.size() > 1);
    CHECK(told.front().document);  // what is not there is not shown meanwhile
    CHECK(told.front().tree);
    CHECK(told.back().lesson);
}

TEST_CASE("app: what the newest work throws comes to who takes its answer, once") {
    NewestWork<int> work;
    work.ask([](const std::stop_token&) -> int { throw std::bad_alloc(); });
    CHECK_THROWS_AS(work.take(10s), std::bad_alloc);
    CHECK_FALSE(work.take(1ms));
    work.ask([](const std::stop_token&) { return 7; });
    CHECK(work.take(10s) == 7);
}

TEST_CASE("app: what older work throws is dropped with its answer") {
    NewestWork<int> work;
    std::atomic<bool> begun = false;
    work.ask([&](const std::stop_token& stop) -> int {
        begun = true;
        while (!stop.stop_requested()) {
            std::this_thread::yield();
        }
        throw std::runtime_error("told to stop");
    });
    while (!begun) {
        std::this_thread::yield();
    }
    work.ask([](const std::stop_token&) { return 3; });
    CHECK(work.take(10s) == 3);
}

TEST_CASE("app: a shower of light ends once it is told to") {
    const auto document = test::document_of(test::glass_ball_scene());
    ShowerOptions options;
    options.rays = 20'000;
    const ProgressListener until_stopped(
        [](std::string_view, double share) { share > 0.3 ? throw Stopped() : void(); });
    CHECK_THROWS_AS(shower(document->world(), 0, options), Stopped);
}

}  // namespace
}  // namespace raytree::inspector
