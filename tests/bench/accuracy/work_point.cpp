#include "accuracy/work_point.h"

#include <algorithm>
#include <cmath>

#include "support/report.h"

namespace raytree::bench {
namespace {

/// "3.8", "250"
std::string times_text(double ratio) {
    const double unit = ratio < 10 ? 0.1 : std::pow(10, std::floor(std::log10(ratio)) - 1);
    return Cell(std::round(ratio / unit) * unit, ratio < 10 ? 1 : 0).shown();
}

/// Whether `q` is faster and no worse than `p`, or better and no slower. Two that do the same work
/// are never timed alike: faster is what is so by more than 5 % and by more than the spread.
bool beats(const WorkPoint& q, const WorkPoint& p) {
    const double error = q.intensity.rms(), own = p.intensity.rms();
    const bool faster = q.seconds < 0.95 * p.seconds && q.high < p.low;
    return (faster && error <= own * (1 + 1e-9)) ||
           (q.seconds < 1.05 * p.seconds && error < 0.95 * own);
}

}  // namespace

void mark_front(std::vector<WorkPoint>& points) {
    for (WorkPoint& p : points) {
        p.on_front = std::ranges::none_of(points, [&](const WorkPoint& q) { return beats(q, p); });
    }
}

std::string verdict_on_default(const std::vector<WorkPoint>& points) {
    const auto own = std::ranges::find(points, "default", &WorkPoint::family);
    const std::string name = "the default settings (6 levels, smallest weight 0.001, double)";
    if (own->on_front) {
        return name + " are on the front";
    }
    const WorkPoint* better = nullptr;  // the most exact of those that beat it
    for (const WorkPoint& p : points) {
        if (beats(p, *own) && (!better || p.intensity.rms() < better->intensity.rms())) {
            better = &p;
        }
    }
    const double share = 100 * better->seconds / own->seconds;
    const double ratio = own->intensity.rms() / better->intensity.rms();
    const std::string what = better->family == "max_depth"
                                 ? better->label + " levels with any weight"
                             : better->family == "min_weight"
                                 ? "a smallest weight of " + better->label + " with any depth"
                                 : better->label;
    const std::string why =
        better->family == "max_depth"
            ? "the trees of this scene end sooner; the default is for those that do not"
        : better->family == "min_weight"
            ? "in this scene light gets weak soon; the default also bounds the trees of "
              "scenes where it does not"
            : "where cut trees are the larger error rounding does not matter; the default is "
              "for those who look at numbers";
    return name + " are not on the front: " + what + " takes " +
           std::to_string(static_cast<int>(std::round(share))) + " % of the time with " +
           (ratio > 1.05 ? "an error " + times_text(ratio) + " times smaller"
                         : std::string("the same error")) +
           "; " + why;
}

}  // namespace raytree::bench
