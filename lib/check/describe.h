#pragma once

#include <string>
#include <string_view>

#include "check/check.h"

/// Findings in words.
namespace raytree::check {

/// What there is to say of a field when it is wrong.
struct FieldText {
    std::string_view name;     ///< for people
    std::string_view formula;  ///< by which it is computed
    std::string_view topic;    ///< of the lecture
};
const FieldText& text_of(Field field);

/// A hint, stronger from one to the next.
struct Hints {
    std::string where, quantity, formula;
};

/// "ray", "pixel", or the field's word: the `quantity` of the report.
std::string quantity_of(const Finding& finding);
/// "(0.1, 0, -0.99)", "ball", "nothing".
std::string value_text(const Value& value);
/// "ray 7, refracted, level 3".
std::string ray_text(const Finding& finding, const Report& report);
/// One sentence, with the numbers.
std::string sentence(const Finding& finding, const Report& report);
/// Why it is held against the submission.
std::string rationale(const Finding& finding);
Hints hints(const Finding& finding, const Report& report);
std::string_view word_of(Verdict verdict);
/// Without control characters, and of a length that fits into a report: submissions are hostile.
std::string harmless(std::string_view text);

}  // namespace raytree::check
