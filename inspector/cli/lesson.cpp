#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <memory>

#include "command.h"
#include "formats/output_file.h"
#include "formats/styled_text.h"
#include "lesson/check_lesson.h"
#include "lesson/lesson_folder.h"
#include "lesson/lesson_text.h"
#include "scene_arguments.h"
#include "tree/explain.h"
#include "values.h"

namespace raytree::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* examples =
    "Examples:\n"
    "  raytree lesson list              the lessons, in the lecture's order\n"
    "  raytree lesson show 4            the fourth, to read\n"
    "  raytree lesson show spheres --step 3\n"
    "  raytree lesson check             do all claims of all lessons hold?";

struct Arguments {
    std::string folder;  ///< empty: the program's own
    std::string name;
    std::vector<std::string> names;
    std::optional<int> step;
};

fs::path folder_of(const Arguments& arguments) {
    return arguments.folder.empty() ? lesson::own_lessons() : fs::path(arguments.folder);
}

void add_folder(CLI::App& app, const std::shared_ptr<Arguments>& arguments) {
    add_value(app, "--lessons", "FOLDER", "where the lessons are (default: the program's own)",
              [arguments](const std::string& text) { arguments->folder = text; });
}

std::shared_ptr<const lesson::Lesson> load(const fs::path& folder, const std::string& name) {
    auto loaded = lesson::load_lesson(folder, name);
    for (const std::string& warning : loaded->warnings) {
        say("warning: " + warning);
    }
    return loaded;
}

int list(const Arguments& arguments) {
    const fs::path folder = folder_of(arguments);
    std::string text;
    for (const std::string& name : lesson::lesson_names(folder)) {
        const auto loaded = load(folder, name);
        text += padded(name, 28) + "  " + padded(std::to_string(loaded->minutes), 3) + "min  " +
                loaded->title + "\n";
    }
    write_output("-", text);
    return done;
}

int show(const Arguments& arguments) {
    const lesson::Play play(load(folder_of(arguments), arguments.name));
    const auto steps = static_cast<int>(play.lesson().steps.size());
    lesson::LessonTextOptions options;
    const char* const no_colour = std::getenv("NO_COLOR");
    options.colour = isatty(STDOUT_FILENO) == 1 && (!no_colour || *no_colour == '\0');
    if (arguments.step) {
        if (*arguments.step < 1 || *arguments.step > steps) {
            throw wrong_value("--step", std::to_string(*arguments.step),
                              "a whole number from 1 to " + std::to_string(steps));
        }
        options.step = static_cast<std::size_t>(*arguments.step - 1);
    }
    write_output("-", write_lesson_text(play, options));
    return done;
}

std::string minutes_text(double minutes) {
    return number_text(std::round(10 * minutes) / 10) + " minutes";
}

int check(const Arguments& arguments) {
    const fs::path folder = folder_of(arguments);
    std::vector<std::string> names;
    for (const std::string& name : arguments.names) {
        names.push_back(lesson::find_lesson(folder, name));
    }
    if (names.empty()) {
        names = lesson::lesson_names(folder);
    }
    bool all_hold = true;
    for (const std::string& name : names) {
        const lesson::Play play(load(folder, name));
        const lesson::LessonCheck checked = lesson::check_lesson(play);
        for (const Mistake& failure : checked.failures) {
            say(failure.message());
        }
        all_hold = all_hold && checked.failures.empty();
        write_output("-", padded(name, 28) + "  " + std::to_string(checked.steps) + " steps, " +
                              std::to_string(checked.questions) + " questions, " +
                              std::to_string(checked.claims) + " claims, " +
                              std::to_string(checked.references) + " references: " +
                              (checked.failures.empty()
                                   ? "all hold, takes " + minutes_text(checked.minutes)
                                   : std::to_string(checked.failures.size()) + " do not hold") +
                              "\n");
    }
    return all_hold ? done : found_wrong;
}

}  // namespace

Command lesson_command(CLI::App& program) {
    const auto arguments = std::make_shared<Arguments>();
    CLI::App* const app =
        program.add_subcommand("lesson", "Lessons on ray tracing: list, read and check them.");
    app->footer(examples);
    app->require_subcommand(1);
    CLI::App* const lists = app->add_subcommand("list", "The lessons that there are.");
    add_folder(*lists, arguments);
    CLI::App* const shows = app->add_subcommand("show", "A lesson as text.");
    shows->add_option("NAME", arguments->name, "a lesson's name or number")
        ->option_text(" ")
        ->required();
    add_value(*shows, "--step", "K", "this step alone, from 1",
              [arguments](const std::string& text) {
                  arguments->step = whole_number(text);
                  if (!arguments->step) {
                      throw wrong_value("--step", text, "a whole number from 1");
                  }
              });
    add_folder(*shows, arguments);
    CLI::App* const checks =
        app->add_subcommand("check", "Holds all that lessons claim against the tracer.");
    checks->add_option("NAME", arguments->names, "lessons (default: all)")->option_text(" ");
    add_folder(*checks, arguments);
    return {app, [=] {
                return lists->parsed()   ? list(*arguments)
                       : shows->parsed() ? show(*arguments)
                                         : check(*arguments);
            }};
}

}  // namespace raytree::cli
