#pragma once

#include <quadmath.h>

#include <cmath>
#include <limits>

/// The three arithmetics of raytree and the few functions that all of them share.
///
/// The tracer is a template over a type `T` that is one of `float`, `double` and `Quad`; calls such
/// as `sqrt(x)` inside namespace raytree find the right function for each.
namespace raytree {

/// The reference arithmetic: IEEE binary128, 113 significand bits, about 34 decimal digits.
__extension__ using Quad = __float128;

using std::abs;
using std::acos;
using std::fma;
using std::isfinite;
using std::pow;
using std::sqrt;
using std::tan;

#ifdef __STRICT_ANSI__  // else the standard library has it
inline Quad abs(Quad x) { return fabsq(x); }
#endif
inline Quad acos(Quad x) { return acosq(x); }
inline Quad fma(Quad a, Quad b, Quad c) { return fmaq(a, b, c); }
inline bool isfinite(Quad x) { return finiteq(x) != 0; }
inline Quad pow(Quad base, Quad exponent) { return powq(base, exponent); }
inline Quad sqrt(Quad x) { return sqrtq(x); }
inline Quad tan(Quad x) { return tanq(x); }

template <class T> constexpr T max_of(T a, T b) { return a < b ? b : a; }
template <class T> constexpr T min_of(T a, T b) { return b < a ? b : a; }

/// What differs between the arithmetics: the unit roundoff, infinity and pi.
template <class T> struct Real {
    /// Half the distance from 1 to the next number: the largest relative error of one rounding.
    static constexpr T unit_roundoff = std::numeric_limits<T>::epsilon() / 2;
    static constexpr T infinity = std::numeric_limits<T>::infinity();
    static constexpr T pi = static_cast<T>(3.14159265358979323846264338327950288L);
    /// Lengths from 1 / largest_length to largest_length can be squared and multiplied with each
    /// other in every formula of the library; a scene with others is refused.
    static constexpr T largest_length =
        static_cast<T>(sizeof(T) == sizeof(float) ? 0x1p+60 : 0x1p+500);
    /// Factors likewise: of transforms and between refractive indices.
    static constexpr T largest_factor =
        static_cast<T>(sizeof(T) == sizeof(float) ? 0x1p+30 : 0x1p+250);
};

template <> struct Real<Quad> {
    static constexpr Quad unit_roundoff = static_cast<Quad>(0x1p-113);
    static constexpr Quad infinity = static_cast<Quad>(std::numeric_limits<double>::infinity());
    static inline const Quad pi = acosq(-1);
    // Not larger than for double: boxes are of doubles.
    static constexpr Quad largest_length = Real<double>::largest_length;
    static constexpr Quad largest_factor = Real<double>::largest_factor;
};

}  // namespace raytree
