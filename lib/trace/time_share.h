#pragma once

#include "trace/world.h"

namespace raytree {

/// Where the time of a picture goes, measured in this thread's processor time.
struct TimeShare {
    std::size_t rays = 0;                 ///< that were timed
    double all = 0;                       ///< seconds, of all that tracing does
    double intersection = 0;              ///< of finding what the rays meet, with the hierarchy
    double brute_force_intersection = 0;  ///< of the same with every shape asked
    bool operator==(const TimeShare&) const = default;
    double share() const { return all > 0 ? intersection / all : 0; }
    /// What the share would be without a hierarchy: all else takes as long as it did.
    double brute_force_share() const {
        const double rest = all > intersection ? all - intersection : 0;
        return brute_force_intersection / (rest + brute_force_intersection);
    }
};

/// What the lecture gives for the share without a hierarchy: from and to.
inline constexpr double lecture_intersection_share[] = {0.75, 0.95};

/// Traces some of the picture's pixels (all where it is small), then asks the same rays again for
/// nothing but their hits. A measurement: it differs from run to run.
TimeShare measure_time_share(const World<double>& world);

}  // namespace raytree
