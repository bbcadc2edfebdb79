#pragma once

#include <vector>

#include "lesson/play.h"

namespace raytree::lesson {

/// Answers of all sorts to a step's question, right and wrong: numbers around the truth, every
/// option, every ray (of the first 1000), pixels all over the picture, so many in a row, values
/// from end to end. Throws ExpressionError or InputError.
std::vector<Json> sample_answers(const Play& play, std::size_t step, int pixels_in_a_row = 9);

}  // namespace raytree::lesson
