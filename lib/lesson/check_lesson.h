#pragma once

#include <vector>

#include "lesson/play.h"
#include "scene/input_error.h"

namespace raytree::lesson {

struct LessonCheck {
    std::vector<Mistake> failures;  ///< what does not hold, each with its file and place
    std::size_t steps = 0, questions = 0, claims = 0, references = 0;  ///< that were looked at
    double minutes = 0;  ///< that it takes (reading_minutes); 0 where something does not hold
};

/// Holds everything that a lesson says against the tracer: its scenes can be read, what it shows is
/// there, every number in its texts can be looked up, its claims are true, and each question has a
/// right answer and hints that are for wrong ones.
LessonCheck check_lesson(const Play& play);

}  // namespace raytree::lesson
