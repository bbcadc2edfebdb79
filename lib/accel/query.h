#pragma once

#include <cstddef>

#include "geometry/ray.h"

namespace raytree {

/// Where a ray meets a shape.
template <class T> struct Hit {
    T t{};
    PrimitiveId primitive = no_primitive;

    /// The order in which hits are met: by t, of equal t the first shape in the scene.
    friend bool operator<(const Hit& a, const Hit& b) {
        return a.t < b.t || (a.t == b.t && a.primitive < b.primitive);
    }
};

/// The part of a ray in which hits are looked for: `from <= t < to`, and t > 0 in any case.
template <class T> struct Interval {
    T from = 0;
    T to = Real<T>::infinity;

    bool contains(T t) const { return t >= from && t < to; }
};

/// A ray with what else is asked of it.
template <class T> struct Query {
    Ray<T> ray;
    PrimitiveId leaving = no_primitive;  ///< the shape that the ray starts on, if on one
    Interval<T> interval;
};

/// What is known of rays that are handed over together. It decides how they are followed and
/// never what they meet.
enum class Together {
    any_order,  ///< nothing
    coherent,   ///< sixteen in a row start near each other and go much the same way
};

}  // namespace raytree
