#include "scene/input_error.h"

#include "scene/utf8.h"

namespace raytree {
namespace {

std::string all_messages(const std::vector<Mistake>& mistakes) {
    std::string text;
    for (const Mistake& mistake : mistakes) {
        text += (text.empty() ? "" : "\n") + mistake.message();
    }
    return text;
}

}  // namespace

std::string Mistake::message() const {
    std::string text_so_far;
    for (const std::string* part : {&file, &place, &text}) {
        if (!part->empty()) {
            text_so_far += (text_so_far.empty() ? "" : ": ") + *part;
        }
    }
    return legible(text_so_far);
}

InputError::InputError(std::vector<Mistake> mistakes)
    : std::runtime_error(all_messages(mistakes)), mistakes_(std::move(mistakes)) {}

}  // namespace raytree
