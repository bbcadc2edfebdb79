#pragma once

#include <algorithm>
#include <ctime>
#include <limits>

namespace raytree {

/// The processor time that this thread has taken so far, in seconds: other programs do not count.
inline double processor_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The least time of a few runs: what disturbs only makes a run longer.
template <class Work> double thread_time_of(Work work, int runs = 1) {
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < runs; ++k) {
        const double start = processor_seconds();
        work();
        least = std::min(least, processor_seconds() - start);
    }
    return least;
}

}  // namespace raytree
