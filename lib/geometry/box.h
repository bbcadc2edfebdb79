#pragma once

#include <array>
#include <limits>

#include "math/vector.h"

namespace raytree {

/// An axis-parallel box; empty where min > max. What it includes it has exactly; how much wider it
/// must be for what is computed in it, ShapeSet::bounds says, and the hierarchy that meets it
/// rounds outwards (Ize, "Robust BVH ray traversal", JCGT 2(2), 2013).
struct Box {
    Vec3<double> min{std::numeric_limits<double>::infinity()};
    Vec3<double> max{-std::numeric_limits<double>::infinity()};

    void include(const Vec3<double>& p) {
        for (int k = 0; k < 3; ++k) {
            min[k] = min_of(min[k], p[k]);
            max[k] = max_of(max[k], p[k]);
        }
    }
    void include(const Box& box) {
        for (int k = 0; k < 3; ++k) {
            min[k] = min_of(min[k], box.min[k]);
            max[k] = max_of(max[k], box.max[k]);
        }
    }
    void pad(double margin) {
        min -= Vec3<double>(margin);
        max += Vec3<double>(margin);
    }
    bool empty() const { return !(min.x <= max.x); }
    Vec3<double> center() const { return 0.5 * min + 0.5 * max; }
    Vec3<double> size() const { return max - min; }
    /// Half the surface area.
    double half_area() const {
        const Vec3<double> s = size();
        return s.x * s.y + s.y * s.z + s.z * s.x;
    }
};

}  // namespace raytree
