#include "check/one_factor.h"

#include <cmath>
#include <numeric>

namespace raytree::check {
namespace {

constexpr double close = 1e-4;

bool is_colour(Field field) {
    return field == Field::ambient || field == Field::diffuse || field == Field::specular ||
           field == Field::intensity;
}

/// What was found in terms of what was expected: the factor between the two colours; none where
/// there is not one for all channels.
std::optional<double> factor_of(const Finding& finding) {
    const auto& expected = finding.expected.numbers.x;
    const auto& found = finding.found.numbers.x;
    const double product = std::inner_product(expected.begin(), expected.end(), found.begin(), 0.0);
    const double square =
        std::inner_product(expected.begin(), expected.end(), expected.begin(), 0.0);
    const double factor = product / square;
    for (std::size_t k = 0; k < expected.size(); ++k) {
        if (!(abs(found[k] - factor * expected[k]) <= close * abs(factor) * std::sqrt(square))) {
            return std::nullopt;
        }
    }
    return factor;
}

}  // namespace

std::optional<double> one_factor(const Report& report) {
    std::optional<double> all;
    for (const Finding& finding : report.findings) {
        if (finding.follows_from) {
            continue;
        }
        if (finding.problem != Problem::differs || !is_colour(finding.field)) {
            return std::nullopt;
        }
        const std::optional<double> factor = factor_of(finding);
        if (!factor || abs(*factor) < 1e-6 || (all && abs(*all - *factor) > 1e-3 * abs(*all))) {
            return std::nullopt;
        }
        all = all ? all : factor;
    }
    return all;
}

}  // namespace raytree::check
