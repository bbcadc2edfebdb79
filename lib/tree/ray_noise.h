#pragma once

#include <vector>

#include "math/vector.h"

namespace raytree {

/// What one source of rounding does to a ray, or to a hit: how far it moves each of two vectors.
struct Noise {
    Vec3<double> place{};  ///< a ray's origin, a hit's point
    Vec3<double> way{};    ///< a ray's direction, a hit's normal
};

using NoiseList = std::vector<Noise>;

/// A source of unknown direction: three, along the axes.
inline void add_noise(NoiseList& list, double place, double way) {
    for (int axis = 0; axis < 3; ++axis) {
        Noise noise;
        noise.place[axis] = place;
        noise.way[axis] = way;
        list.push_back(noise);
    }
}

/// The sum over all sources of `size(noise)`.
template <class Size> double total(const NoiseList& list, Size&& size) {
    double sum = 0;
    for (const Noise& noise : list) {
        sum += size(noise);
    }
    return sum;
}

inline Vec3<double> across(const Vec3<double>& v, const Vec3<double>& axis) {
    return v - inner(v, axis) * axis;
}

}  // namespace raytree
