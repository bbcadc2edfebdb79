#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/ray.h"
#include "scene/affine.h"

namespace raytree {

/// An invertible affine transform with its inverse (by cofactors; Higham, Accuracy and Stability of
/// Numerical Algorithms, 2nd ed. 2002, ch. 14), between a shape's own space and the world. With A
/// and B the Frobenius norms of its matrix and of the inverse's, and c = A B:
template <class T> class AffineMap {
  public:
    /// `matrix` must be invertible; its inverse is that of the doubles given, computed in T.
    explicit AffineMap(const Affine& matrix);

    /// Whether every factor, there and back, is in the range of the arithmetic.
    bool in_range() const;

    /// Off by at most u (4 A |p| + 2 |translation|).
    Vec3<T> point_to_world(const Vec3<T>& p) const;
    /// By the inverse transpose, made unit. Off by at most 8 c u.
    UnitVec3<T> normal_to_world(const UnitVec3<T>& n) const;
    /// The same ray in the shape's own space: t is unchanged, so the direction is not unit there.
    /// It is off by at most 8 c B u, the origin by B u (8 c |o| + 2 |origin| + 2 |translation|),
    /// with o the origin from the translation.
    Ray<T> ray_to_own_space(const Ray<T>& ray) const;

  private:
    std::array<Vec3<T>, 3> rows_;
    Vec3<T> translation_;
    std::array<Vec3<T>, 3> inverse_rows_;
};

template <class T> AffineMap<T>::AffineMap(const Affine& m) {
    std::array<Vec3<T>, 3> columns;  // each scaled by a power of two: products stay in range
    std::array<T, 3> scales;
    for (std::size_t k = 0; k < 3; ++k) {
        const double size = std::max({std::abs(m[0][k]), std::abs(m[1][k]), std::abs(m[2][k])});
        scales[k] = static_cast<T>(std::ldexp(1.0, -std::ilogb(size)));
    }
    for (int i = 0; i < 3; ++i) {
        const auto k = static_cast<std::size_t>(i);
        rows_[k] = vector_cast<T>(Vec3<double>(m[k][0], m[k][1], m[k][2]));
        translation_[i] = static_cast<T>(m[k][3]);
        for (int j = 0; j < 3; ++j) {
            columns[k][j] = static_cast<T>(m[static_cast<std::size_t>(j)][k]) * scales[k];
        }
    }
    const T determinant = inner(columns[0], outer(columns[1], columns[2]));
    for (std::size_t k = 0; k < 3; ++k) {
        inverse_rows_[k] =
            outer(columns[(k + 1) % 3], columns[(k + 2) % 3]) * (scales[k] / determinant);
    }
}

template <class T> bool AffineMap<T>::in_range() const {
    T largest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        largest = max_of(largest, largest_component(rows_[k]));
        largest = max_of(largest, largest_component(inverse_rows_[k]));
        if (!isfinite(inner(rows_[k], inverse_rows_[k]))) {
            return false;
        }
    }
    return largest <= Real<T>::largest_factor &&
           largest_component(translation_) <= Real<T>::largest_length;
}

template <class T> Vec3<T> AffineMap<T>::point_to_world(const Vec3<T>& p) const {
    return Vec3<T>(inner(rows_[0], p), inner(rows_[1], p), inner(rows_[2], p)) + translation_;
}

template <class T> UnitVec3<T> AffineMap<T>::normal_to_world(const UnitVec3<T>& n) const {
    const Vec3<T>& v = n.vec();
    return UnitVec3<T>::of(v.x * inverse_rows_[0] + v.y * inverse_rows_[1] +
                           v.z * inverse_rows_[2]);
}

template <class T> Ray<T> AffineMap<T>::ray_to_own_space(const Ray<T>& ray) const {
    const Vec3<T> o = ray.origin - translation_;
    Ray<T> own;
    own.going = ray.going;
    const T reach = largest_component(o) + largest_component(translation_);
    for (int i = 0; i < 3; ++i) {
        const Vec3<T>& row = inverse_rows_[static_cast<std::size_t>(i)];
        own.origin[i] = inner(row, o);
        own.direction[i] = inner(row, ray.direction);
        const T gain = abs(row.x) + abs(row.y) + abs(row.z);
        own.origin_error = max_of(own.origin_error,
                                  gain * (ray.origin_error + 4 * Real<T>::unit_roundoff * reach));
    }
    return own;
}

}  // namespace raytree
