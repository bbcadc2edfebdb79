#include "check/evidence.h"

#include <algorithm>
#include <cmath>

namespace raytree::check {
namespace {

constexpr std::size_t alike_by_chance = 3;  // decisions

bool is_number(const Finding& finding) {
    return finding.problem == Problem::differs && finding.found.numbers.size > 0;
}

/// A reflected ray that is right but for the signs of its components.
bool differs_in_signs(const Finding& finding) {
    const auto& due = finding.expected.numbers.x;
    const auto& found = finding.found.numbers.x;
    return finding.field == Field::direction && finding.kind == RayKind::reflected &&
           std::ranges::equal(due, found, [](double x, double y) {
               return std::abs(std::abs(x) - std::abs(y)) < 1e-4;
           });
}

}  // namespace

bool tells_enough(const Report& report) {
    std::size_t decisions = 0;
    for (const Finding& finding : report.findings) {
        if (is_number(finding)) {
            return true;
        }
        decisions += finding.problem != Problem::whole && !finding.follows_from ? 1 : 0;
    }
    return decisions > 2;
}

bool is_unmistakable(const Report& report) {
    std::size_t decisions = 0;
    for (const Finding& finding : report.findings) {
        if (finding.follows_from || finding.problem == Problem::whole) {
            continue;
        }
        if (is_number(finding) && finding.field != Field::transmittance &&
            !differs_in_signs(finding)) {
            return true;
        }
        ++decisions;
    }
    return decisions > alike_by_chance;
}

}  // namespace raytree::check
