#pragma once

#include "math/real.h"

/// Error-free transformations, and sums and differences that keep their digits by them.
/// None of them survives contraction or reassociation: the library is built without both.
namespace raytree {

/// `a b - c d` to a relative error of 1.5 units in the last place (Kahan; analysed by Jeannerod,
/// Louvet & Muller, "Further analysis of Kahan's algorithm for the accurate computation of 2 x 2
/// determinants", 2013, Theorem 1.1).
template <class T> T difference_of_products(T a, T b, T c, T d) {
    const T cd = c * d;
    const T error = fma(-c, d, cd);
    return fma(a, b, -cd) + error;
}

/// A rounded result together with what the rounding took away: `value + error` is exact.
template <class T> struct Exact {
    T value;
    T error;
};

/// Knuth's TwoSum.
template <class T> Exact<T> two_sum(T a, T b) {
    const T sum = a + b;
    const T b_part = sum - a;
    return {sum, (a - (sum - b_part)) + (b - b_part)};
}

/// TwoProduct by a fused multiply-add.
template <class T> Exact<T> two_product(T a, T b) {
    const T product = a * b;
    return {product, fma(a, b, -product)};
}

}  // namespace raytree
