#pragma once

#include <glm/vec3.hpp>

#include "math/exact.h"
#include "math/real.h"

namespace raytree {

/// A point or a displacement in space; in the scene's length unit unless said otherwise.
template <class T> using Vec3 = glm::vec<3, T, glm::defaultp>;

/// The component along an axis (0, 1, 2) that only the data tell: glm's `[]` would branch on it,
/// which no processor can guess.
template <class T> const T& component(const Vec3<T>& v, int axis) { return (&v.x)[axis]; }

template <class To, class From> Vec3<To> vector_cast(const Vec3<From>& v) {
    return {static_cast<To>(v.x), static_cast<To>(v.y), static_cast<To>(v.z)};
}

template <class T> T inner(const Vec3<T>& a, const Vec3<T>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// The cross product, each component to a relative error of 1.5 units in the last place, however
/// much its two products cancel (Kahan's difference of products).
template <class T> Vec3<T> outer(const Vec3<T>& a, const Vec3<T>& b) {
    return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
            difference_of_products(a.x, b.y, a.y, b.x)};
}

template <class T> T largest_component(const Vec3<T>& v) {
    return max_of(abs(v.x), max_of(abs(v.y), abs(v.z)));
}

/// Whether the squares of a vector's components can be summed as they are: none is too large, and
/// what underflows is nothing beside the square of the largest, which is given.
template <class T> bool can_be_squared(T largest) {
    return largest >= 1 / Real<T>::largest_length && largest <= Real<T>::largest_length;
}

/// Euclidean length; does not overflow or underflow where the result does not.
template <class T> T length(const Vec3<T>& v) {
    const T scale = largest_component(v);
    if (can_be_squared(scale)) {
        return sqrt(inner(v, v));
    }
    if (!(scale > 0) || !isfinite(scale)) {
        return scale;
    }
    const Vec3<T> unit = v / scale;
    return scale * sqrt(inner(unit, unit));
}

/// `a + t b`, each component rounded once.
template <class T> Vec3<T> along(const Vec3<T>& a, T t, const Vec3<T>& b) {
    return {fma(t, b.x, a.x), fma(t, b.y, a.y), fma(t, b.z, a.z)};
}

/// A vector of length 1 (to within two units in the last place). Only normalising makes one.
template <class T> class UnitVec3 {
  public:
    /// The direction of `v`, which must be finite and not zero.
    static UnitVec3 of(const Vec3<T>& v) {
        const T largest = largest_component(v);
        const Vec3<T> scaled = can_be_squared(largest) ? v : Vec3<T>(v / largest);
        return UnitVec3(scaled / sqrt(inner(scaled, scaled)));
    }

    const Vec3<T>& vec() const { return v_; }
    operator const Vec3<T>&() const { return v_; }
    UnitVec3 operator-() const { return UnitVec3(-v_); }

  private:
    explicit UnitVec3(const Vec3<T>& v) : v_(v) {}
    Vec3<T> v_;
};

template <class T> T inner(const UnitVec3<T>& a, const UnitVec3<T>& b) {
    return inner(a.vec(), b.vec());
}
template <class T> T inner(const UnitVec3<T>& a, const Vec3<T>& b) { return inner(a.vec(), b); }
template <class T> T inner(const Vec3<T>& a, const UnitVec3<T>& b) { return inner(a, b.vec()); }

}  // namespace raytree
