#include "check/conventions.h"

#include <algorithm>

#include "check/convention_tables.h"

namespace raytree::check {

const std::vector<Convention>& conventions() {
    static const std::vector<Convention> table = [] {
        std::vector<Convention> all;
        for (const auto* part :
             {&camera_conventions(), &light_conventions(), &tree_conventions()}) {
            all.insert(all.end(), part->begin(), part->end());
        }
        return all;
    }();
    return table;
}

Choices default_choices() {
    Choices choices;
    for (const Convention& convention : conventions()) {
        if (choices.empty() || choices.back()->axis != convention.axis) {
            choices.push_back(&convention);
        }
    }
    return choices;
}

Choices with_choice(Choices choices, std::string_view choice) {
    const auto equals = choice.find('=');
    for (const Convention& convention : conventions()) {
        if (convention.axis == choice.substr(0, equals) &&
            convention.value == choice.substr(equals + 1)) {
            std::ranges::find(choices, convention.axis, &Convention::axis)[0] = &convention;
        }
    }
    return choices;
}

std::string text_of(const Choices& choices) {
    static const Choices defaults = default_choices();
    std::string text;
    for (std::size_t k = 0; k < choices.size(); ++k) {
        if (choices[k] != defaults[k]) {
            text += (text.empty() ? "" : " ") + std::string(choices[k]->axis) + '=' +
                    std::string(choices[k]->value);
        }
    }
    return text;
}

}  // namespace raytree::check
