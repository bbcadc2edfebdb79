#include <charconv>

#include "lesson/lesson_folder.h"
#include "state/command_groups.h"

namespace raytree::inspector {
namespace {

bool has_lesson(const State& state) { return state.lesson() != nullptr; }
bool has_question(const State& state) {
    return has_lesson(state) && state.lesson()->here().ask.has_value();
}
bool at_end(const State& state) { return state.lesson()->step() + 1 == state.lesson()->count(); }

std::filesystem::path folder_of(const State& state) {
    return state.lesson_folder().empty() ? lesson::own_lessons() : state.lesson_folder();
}

/// The lesson `by` further in the folder; empty where there is none.
std::string neighbour(const State& state, std::ptrdiff_t by) {
    const std::vector<std::string> names = lesson::lesson_names(folder_of(state));
    const auto here = std::ranges::find(names, state.lesson()->lesson().name) - names.begin();
    const std::ptrdiff_t there = here + by;
    const auto count = static_cast<std::ptrdiff_t>(names.size());
    return here < count && there >= 0 && there < count ? names[static_cast<std::size_t>(there)]
                                                       : "";
}

void open(State& state, std::string_view name) {
    if (name.empty()) {
        state.show_lessons(LessonSide::contents);
        return;
    }
    state.open_lesson(lesson::load_lesson(folder_of(state), std::string(name)));
}

void list(State& state, std::string_view) {
    const bool shown = state.lesson_side() == LessonSide::contents;
    state.show_lessons(!shown              ? LessonSide::contents
                       : has_lesson(state) ? LessonSide::lesson
                                           : LessonSide::hidden);
}
bool lists(const State& state) { return state.lesson_side() == LessonSide::contents; }

/// Beyond the last step comes the next lesson.
void next(State& state, std::string_view) {
    if (!at_end(state)) {
        state.go_to_lesson_step(state.lesson()->step() + 1);
        return;
    }
    const std::string name = neighbour(state, 1);
    name.empty() ? state.show_lessons(LessonSide::contents) : open(state, name);
}

void back(State& state, std::string_view) {
    if (state.lesson()->step() > 0) {
        state.go_to_lesson_step(state.lesson()->step() - 1);
    } else if (const std::string name = neighbour(state, -1); !name.empty()) {
        const auto before = lesson::load_lesson(folder_of(state), name);
        state.open_lesson(before, before->steps.size() - 1);
    }
}

void first(State& state, std::string_view) { state.go_to_lesson_step(0); }
void last(State& state, std::string_view) { state.go_to_lesson_step(state.lesson()->count() - 1); }

void go_to(State& state, std::string_view argument) {
    std::size_t step = 0;
    const char* const end = argument.data() + argument.size();
    const auto read = std::from_chars(argument.data(), end, step);
    if (read.ec != std::errc() || read.ptr != end || step < 1 || step > state.lesson()->count()) {
        throw InputError("", "lesson.step",
                         "found '" + std::string(argument) +
                             "', must be a whole number from 1 to " +
                             std::to_string(state.lesson()->count()));
    }
    state.go_to_lesson_step(step - 1);
}

void view(State& state, std::string_view) { state.show_lesson_view(); }
void answer(State& state, std::string_view argument) {
    state.give_answer(state.lesson()->answer_from(argument));
}
void show_answer(State& state, std::string_view) { state.tell_answer(); }
void again(State& state, std::string_view) { state.ask_again(); }
bool has_answer(const State& state) {
    return has_question(state) && state.lesson()->answer() != nullptr;
}
void close(State& state, std::string_view) { state.close_lesson(); }

constexpr Command table[] = {
    {"lesson.list", "Lesson", "All lessons", "F2",
     "Lists the lessons, or goes back to the open one.", none, list, nullptr, lists, "Lessons"},
    {"lesson.open", "", "Open lesson", "",
     "Opens a lesson by its number or name; without one, the list.", Argument::optional, open},
    {"lesson.next",
     "Lesson",
     "Next step",
     "F8 Ctrl+PgDown",
     "Goes to the lesson's next step; after the last to the next lesson.",
     none,
     next,
     has_lesson,
     nullptr,
     {},
     true},
    {"lesson.back", "Lesson", "Step before", "F7 Ctrl+PgUp",
     "Goes to the lesson's step before; from the first to the lesson before.", none, back,
     has_lesson},
    {"lesson.first", "Lesson", "First step", "Shift+F7", "Goes to the lesson's first step.", none,
     first, has_lesson},
    {"lesson.last", "Lesson", "Last step", "Shift+F8", "Goes to the lesson's last step.", none,
     last, has_lesson},
    {"lesson.step", "", "Go to step", "", "Goes to the lesson's step of this number, from 1.",
     Argument::words, go_to, has_lesson},
    {"lesson.view",
     "Lesson",
     "Back to the lesson's view",
     "F6",
     "Shows again what the step is about: its scene, pixel, ray and view.",
     none,
     view,
     has_lesson,
     nullptr,
     {},
     true},
    {"lesson.answer", "", "Answer", "",
     "Answers the question: a number, an option's letter, a pixel I,J, or a ray's number.",
     Argument::words, answer, has_question},
    {"lesson.tell", "Lesson", "Show me the answer", "F9", "Tells the answer to the question.", none,
     show_answer, has_question},
    {"lesson.again", "Lesson", "Ask me again", "Shift+F9", "Takes the answer back.", none, again,
     has_answer},
    {"lesson.close",
     "Lesson",
     "Close the lesson",
     "Ctrl+W",
     "Leaves the lesson; its scene stays.",
     none,
     close,
     has_lesson,
     nullptr,
     {},
     true},
};

}  // namespace

std::span<const Command> lesson_commands() { return table; }

}  // namespace raytree::inspector
