#include "lesson/lesson_folder.h"

#include <algorithm>

#include "formats/did_you_mean.h"
#include "scene/input_error.h"

namespace raytree::lesson {
namespace {

namespace fs = std::filesystem;

constexpr const char* lesson_file = "lesson.json";

/// "04-spheres" as "4".
std::string number_of(const std::string& name) {
    const std::size_t dash = std::min(name.find('-'), name.size());
    const std::size_t first = name.find_first_not_of('0');
    const bool number = dash > 0 && name.find_first_not_of("0123456789") >= dash;
    return number && first < dash ? name.substr(first, dash - first) : "";
}

std::string without_number(const std::string& name) {
    return number_of(name).empty() ? name : name.substr(name.find('-') + 1);
}

}  // namespace

fs::path lessons_beside(const fs::path& program) {
    const fs::path folder = program.parent_path();
    std::error_code error;
    for (const char* const place : {"../../lessons", "../share/raytree/lessons"}) {
        const fs::path lessons = (folder / place).lexically_normal();
        if (fs::is_directory(lessons, error)) {
            return lessons;
        }
    }
    throw InputError("", "lessons",
                     "there is no folder of lessons beside " + program.string() +
                         "; say where it is with --lessons FOLDER");
}

fs::path own_lessons() {
    std::error_code error;
    return lessons_beside(fs::read_symlink("/proc/self/exe", error));
}

std::vector<std::string> lesson_names(const fs::path& folder) {
    std::vector<std::string> names;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; entry != end && !error;
         entry.increment(error)) {
        if (fs::is_regular_file(entry->path() / lesson_file)) {
            names.push_back(entry->path().filename().string());
        }
    }
    if (error) {
        throw InputError(folder.string(), "", "cannot be read: " + error.message());
    }
    if (names.empty()) {
        throw InputError(folder.string(), "", "has no lessons in it: no NAME/lesson.json");
    }
    std::ranges::sort(names);
    return names;
}

std::string find_lesson(const fs::path& folder, const std::string& name) {
    const std::vector<std::string> names = lesson_names(folder);
    const std::string number = number_of(name + "-");
    for (const std::string& lesson : names) {
        if (lesson == name || without_number(lesson) == name ||
            (!number.empty() && number_of(lesson) == number)) {
            return lesson;
        }
    }
    std::vector<std::string> known;
    for (const std::string& lesson : names) {
        known.push_back(without_number(lesson));
    }
    const std::vector<std::string_view> views(known.begin(), known.end());
    const std::string meant = did_you_mean(name, views);
    throw InputError("", "lesson",
                     "there is no lesson '" + name + "'" +
                         (meant.empty() ? "; raytree lesson list names them" : meant));
}

std::shared_ptr<const Lesson> load_lesson(const fs::path& folder, const std::string& name) {
    return std::make_shared<const Lesson>(
        read_lesson(folder / find_lesson(folder, name) / lesson_file));
}

}  // namespace raytree::lesson
