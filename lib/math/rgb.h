#pragma once

#include "math/real.h"

namespace raytree {

/// A linear RGB triple: an intensity, a colour or a coefficient for each channel. Not clamped.
/// Arithmetic is channel by channel. It is no point: it does not mix with Vec3.
template <class T> struct Rgb {
    T r{};
    T g{};
    T b{};

    constexpr Rgb() = default;
    constexpr Rgb(T red, T green, T blue) : r(red), g(green), b(blue) {}
    /// The same number in all three channels.
    constexpr explicit Rgb(T grey) : r(grey), g(grey), b(grey) {}

    constexpr Rgb& operator+=(const Rgb& o) { return *this = *this + o; }
    constexpr Rgb& operator*=(const Rgb& o) { return *this = *this * o; }

    friend constexpr Rgb operator+(const Rgb& x, const Rgb& y) {
        return {x.r + y.r, x.g + y.g, x.b + y.b};
    }
    friend constexpr Rgb operator*(const Rgb& x, const Rgb& y) {
        return {x.r * y.r, x.g * y.g, x.b * y.b};
    }
    friend constexpr Rgb operator*(T s, const Rgb& x) { return {s * x.r, s * x.g, s * x.b}; }
    friend constexpr bool operator==(const Rgb&, const Rgb&) = default;
};

template <class T> constexpr bool is_zero(const Rgb<T>& c) {
    return c.r == 0 && c.g == 0 && c.b == 0;
}

template <class T> constexpr T largest_component(const Rgb<T>& c) {
    return max_of(c.r, max_of(c.g, c.b));
}

template <class T> bool isfinite(const Rgb<T>& c) {
    return isfinite(c.r) && isfinite(c.g) && isfinite(c.b);
}

template <class To, class From> constexpr Rgb<To> rgb_cast(const Rgb<From>& c) {
    return {static_cast<To>(c.r), static_cast<To>(c.g), static_cast<To>(c.b)};
}

}  // namespace raytree
