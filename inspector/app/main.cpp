#include <X11/Xlib.h>

#include <cstdio>
#include <exception>
#include <memory>
#include <span>

#include "arguments.h"
#include "lesson/lesson_folder.h"
#include "state/state.h"
#include "window/opening.h"

namespace raytree::inspector {
namespace {

constexpr int bad_input = 2, no_display = 3;

struct CloseDisplay {
    void operator()(Display* display) const { XCloseDisplay(display); }
};

/// VTK aborts the program where there is no display, so it is asked for before VTK is. The
/// connection is held while the program runs: an X server that loses its last client starts anew,
/// and for that moment refuses the next.
std::unique_ptr<Display, CloseDisplay> open_display() {
    return std::unique_ptr<Display, CloseDisplay>(XOpenDisplay(nullptr));
}

/// The first lesson's name; empty where there are no lessons.
std::string first_lesson(const std::filesystem::path& folder) {
    try {
        return lesson::lesson_names(folder.empty() ? lesson::own_lessons() : folder).front();
    } catch (const InputError&) {
        return {};
    }
}

FirstView lesson_view(const std::filesystem::path& folder, const std::string& name, int step) {
    const auto lesson = lesson::load_lesson(folder.empty() ? lesson::own_lessons() : folder, name);
    if (static_cast<std::size_t>(step) > lesson->steps.size()) {
        throw InputError("", "--step",
                         "found " + std::to_string(step) + ", must be a whole number from 1 to " +
                             std::to_string(lesson->steps.size()));
    }
    return [=](State& state) { state.open_lesson(lesson, static_cast<std::size_t>(step - 1)); };
}

FirstView scene_view(const Arguments& arguments) {
    Opened opened = open_for_window(arguments.file.value_or(RAYTREE_FIRST_SCENE), arguments.scene);
    if (arguments.pixel) {
        if (!opened.document->contains(*arguments.pixel)) {
            const Camera& camera = opened.document->scene().camera;
            throw InputError("", "--pixel",
                             text_of(*arguments.pixel) +
                                 " lies outside the picture; allowed are "
                                 "0,0 to " +
                                 text_of(Pixel{camera.width - 1, camera.height - 1}));
        }
        opened.pixel = arguments.pixel;
    }
    return [=](State& state) { state.show(opened); };
}

/// Reads what is shown first.
FirstView first_view(const Arguments& arguments) {
    const std::filesystem::path folder = arguments.lessons.value_or("");
    const bool alone = !arguments.file && !arguments.pixel;
    const std::string name = arguments.lesson.value_or(alone ? first_lesson(folder) : "");
    const FirstView view = !name.empty() || arguments.lesson
                               ? lesson_view(folder, name, arguments.step)
                               : scene_view(arguments);
    if (!arguments.compare) {
        return view;
    }
    const auto recorded = read_recorded(*arguments.compare);
    return [=](State& state) {
        view(state);
        state.compare_with(recorded);
    };
}

int run(int argc, char** argv) {
    const Arguments arguments =
        parse_arguments(std::span(argv, static_cast<std::size_t>(argc)).subspan(1));
    if (arguments.help) {
        std::fputs(help_text().c_str(), stdout);
        return 0;
    }
    if (arguments.version) {
        std::puts("raytree " RAYTREE_VERSION);
        return 0;
    }
    FirstReading reading = begin_reading([&arguments] { return first_view(arguments); });
    const auto display = open_display();
    if (!display) {
        reading.view.get();  // a file that cannot be read is the worse of two mistakes
        std::fputs(
            "raytree-inspector: there is no display to open a window on (DISPLAY); "
            "xvfb-run gives one to programs on machines without\n",
            stderr);
        return no_display;
    }
    State state;
    state.set_lesson_folder(arguments.lessons.value_or(""));
    state.change_look([&](Look& look) { look.theme = arguments.theme; });
    return run_window(argc, argv, state, std::move(reading), arguments.window);
}

}  // namespace
}  // namespace raytree::inspector

int main(int argc, char** argv) {
    try {
        return raytree::inspector::run(argc, argv);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "raytree-inspector: %s\n", error.what());
        return raytree::inspector::bad_input;
    }
}
