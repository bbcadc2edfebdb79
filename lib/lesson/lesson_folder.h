#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "lesson/lesson.h"

/// A folder of lessons: a folder for each, with lesson.json and its scenes.
namespace raytree::lesson {

/// The folder of the lessons that belong to a program: beside where it was built, or where it is
/// installed. Throws InputError where there is none.
std::filesystem::path lessons_beside(const std::filesystem::path& program);

/// The same for the program that is running.
std::filesystem::path own_lessons();

/// The names of the lessons in `folder`, in their order. Throws InputError where there are none.
std::vector<std::string> lesson_names(const std::filesystem::path& folder);

/// The one lesson that `name` means: its folder's name, its number ("4", "04"), or its name without
/// the number. Throws InputError, with the one that was probably meant.
std::string find_lesson(const std::filesystem::path& folder, const std::string& name);

/// Throws InputError.
std::shared_ptr<const Lesson> load_lesson(const std::filesystem::path& folder,
                                          const std::string& name);

}  // namespace raytree::lesson
