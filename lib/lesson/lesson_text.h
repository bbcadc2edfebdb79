#pragma once

#include <optional>
#include <string>

#include "lesson/play.h"

namespace raytree::lesson {

struct LessonTextOptions {
    bool colour = false;
    std::size_t width = 79;           ///< columns: terminals have 80 or more
    std::optional<std::size_t> step;  ///< from 0; none: all
};

/// A lesson to read in a terminal: its texts with the numbers put in, what each step shows, and its
/// questions with the truth. Throws ExpressionError or InputError.
std::string write_lesson_text(const Play& play, const LessonTextOptions& options = {});

}  // namespace raytree::lesson
