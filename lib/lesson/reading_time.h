#pragma once

#include "lesson/play.h"

namespace raytree::lesson {

/// How long a lesson takes, in minutes, for a student who reads slowly and answers wrongly at
/// first: titles, texts, questions, options, one hint for each question (the longest) and what is
/// said after it at 130 words a minute, numbers and signs of formulas counted as words, and half a
/// minute to find each answer. Throws ExpressionError or InputError.
double reading_minutes(const Play& play);

}  // namespace raytree::lesson
