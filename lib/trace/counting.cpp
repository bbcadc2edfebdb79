#include "trace/counting.h"

namespace raytree {

std::size_t RayCounts::rays() const {
    std::size_t sum = 0;
    for (const OfKind& kind : kinds) {
        sum += kind.rays;
    }
    return sum;
}

RayCounts& RayCounts::operator+=(const RayCounts& other) {
    for (std::size_t k = 0; k < kinds.size(); ++k) {
        kinds[k].rays += other.kinds[k].rays;
        kinds[k].hits += other.kinds[k].hits;
    }
    for (std::size_t k = 0; k < skipped.size(); ++k) {
        skipped[k] += other.skipped[k];
    }
    tests += other.tests;
    return *this;
}

}  // namespace raytree
