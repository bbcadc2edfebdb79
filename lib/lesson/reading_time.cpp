#include "lesson/reading_time.h"

#include <algorithm>
#include <iterator>
#include <sstream>

namespace raytree::lesson {
namespace {

constexpr double words_a_minute = 130;
constexpr double minutes_a_question = 0.5;

std::ptrdiff_t words_of(const std::string& text) {
    std::istringstream words(text);
    return std::distance(std::istream_iterator<std::string>(words), {});
}

std::ptrdiff_t words_of(const Text& text, const Scope& scope) {
    return words_of(plain_text(fill(text, scope)));
}

std::ptrdiff_t words_of(const Ask& ask, const Scope& scope) {
    std::ptrdiff_t words = words_of(ask.question, scope) + words_of(ask.after, scope);
    std::ptrdiff_t hint = 0;
    for (const Option& option : ask.options) {
        words += words_of(option.text, scope);
        hint = std::max(hint, words_of(option.hint, scope));
    }
    for (const Hint& other : ask.hints) {
        hint = std::max(hint, words_of(other.text, scope));
    }
    return words + hint;
}

}  // namespace

double reading_minutes(const Play& play) {
    std::ptrdiff_t words = 0;
    double minutes = 0;
    for (std::size_t k = 0; k < play.lesson().steps.size(); ++k) {
        const Step& step = play.step(k);
        const auto scope = play.scope(k);
        words += words_of(step.title) + words_of(step.text, *scope);
        if (step.ask) {
            words += words_of(*step.ask, *scope);
            minutes += minutes_a_question;
        }
    }
    return minutes + static_cast<double>(words) / words_a_minute;
}

}  // namespace raytree::lesson
