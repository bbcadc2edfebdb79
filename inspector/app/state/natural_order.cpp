#include "state/natural_order.h"

#include <algorithm>
#include <cstddef>

namespace raytree::inspector {
namespace {

/// Takes the run of digits, or else the one character, with which a text begins.
std::string_view take_part(std::string_view& text) {
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    const std::size_t digits =
        static_cast<std::size_t>(std::ranges::find_if_not(text, is_digit) - text.begin());
    const std::string_view part = text.substr(0, std::max<std::size_t>(digits, 1));
    text.remove_prefix(part.size());
    return part;
}

std::string_view without_zeros(std::string_view digits) {
    digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size()));
    return digits;
}

bool is_number(std::string_view part) { return part.front() >= '0' && part.front() <= '9'; }

}  // namespace

bool NaturalOrder::operator()(std::string_view a, std::string_view b) const {
    std::string_view rest_a = a, rest_b = b;
    while (!rest_a.empty() && !rest_b.empty()) {
        const std::string_view x = take_part(rest_a), y = take_part(rest_b);
        if (!is_number(x) || !is_number(y)) {
            if (x != y) {
                return x < y;
            }
            continue;
        }
        const std::string_view m = without_zeros(x), n = without_zeros(y);
        if (m != n) {
            return m.size() != n.size() ? m.size() < n.size() : m < n;
        }
    }
    return rest_a.size() != rest_b.size() ? rest_a.size() < rest_b.size() : a < b;
}

}  // namespace raytree::inspector
