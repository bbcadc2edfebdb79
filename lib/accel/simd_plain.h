#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

/// Eight floats side by side, in plain C++: loops of fixed length without a branch.
namespace raytree::plain {

struct F8 {
    std::array<float, 8> lane;

    static F8 load(const float* p) {
        F8 r;
        for (std::size_t k = 0; k < 8; ++k) {
            r.lane[k] = p[k];
        }
        return r;
    }
    static F8 all(float x) {
        F8 r;
        r.lane.fill(x);
        return r;
    }
    void store(float* p) const {
        for (std::size_t k = 0; k < 8; ++k) {
            p[k] = lane[k];
        }
    }
};

template <class Operation> F8 each(const F8& a, const F8& b, Operation&& operation) {
    F8 r;
    for (std::size_t k = 0; k < 8; ++k) {
        r.lane[k] = operation(a.lane[k], b.lane[k]);
    }
    return r;
}

inline F8 operator+(const F8& a, const F8& b) {
    return each(a, b, [](float x, float y) { return x + y; });
}
inline F8 operator-(const F8& a, const F8& b) {
    return each(a, b, [](float x, float y) { return x - y; });
}
inline F8 operator*(const F8& a, const F8& b) {
    return each(a, b, [](float x, float y) { return x * y; });
}
inline F8 min(const F8& a, const F8& b) {
    return each(a, b, [](float x, float y) { return x < y ? x : y; });
}
inline F8 max(const F8& a, const F8& b) {
    return each(a, b, [](float x, float y) { return x > y ? x : y; });
}
inline F8 abs(const F8& a) {
    return each(a, a, [](float x, float) { return x < 0 ? -x : x; });
}
/// `b`, or -b where a is negative.
inline F8 with_sign_of(const F8& a, const F8& b) {
    return each(a, b, [](float x, float y) { return std::signbit(x) ? -y : y; });
}
inline F8 square_root(const F8& a) {
    return each(a, a, [](float x, float) { return std::sqrt(x); });
}
/// `a b + c` and `a b - c` and `c - a b`, rounded once or twice.
inline F8 multiply_add(const F8& a, const F8& b, const F8& c) { return a * b + c; }
inline F8 multiply_subtract(const F8& a, const F8& b, const F8& c) { return a * b - c; }
inline F8 subtract_product(const F8& c, const F8& a, const F8& b) { return c - a * b; }

/// A bit for each lane with a <= b.
inline unsigned less_equal(const F8& a, const F8& b) {
    unsigned bits = 0;
    for (std::size_t k = 0; k < 8; ++k) {
        bits |= (a.lane[k] <= b.lane[k] ? 1U : 0U) << k;
    }
    return bits;
}

inline float smallest_of(const F8& a) { return *std::min_element(a.lane.begin(), a.lane.end()); }
inline float largest_of(const F8& a) { return *std::max_element(a.lane.begin(), a.lane.end()); }

/// Appends near[k] and ref[k] of the lanes k of `met` to both lists, in the order that `order`
/// has at bits `shift`; returns how many. Eight places are written in any case.
inline std::size_t append(const F8& near, const std::uint32_t* ref, unsigned met,
                          const std::uint32_t* order, unsigned shift, float* nears,
                          std::uint32_t* refs) {
    std::size_t count = 0;
    for (std::size_t place = 0; place < 8; ++place) {
        const std::size_t k = order[place] >> shift & 7;
        nears[count] = near.lane[k];
        refs[count] = ref[k];
        count += met >> k & 1;
    }
    return count;
}

/// The same for ref[k] alone, in any order.
inline std::size_t append_unordered(const std::uint32_t* ref, unsigned met, std::uint32_t* refs) {
    std::size_t count = 0;
    for (std::size_t k = 0; k < 8; ++k) {
        refs[count] = ref[k];
        count += met >> k & 1;
    }
    return count;
}

}  // namespace raytree::plain
