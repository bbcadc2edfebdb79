#pragma once

#include <algorithm>

#include "check/replay.h"

/// What the files of the replay have in common.
namespace raytree::check {

/// How far off the surface programs start rays, of the distance from which a point is computed.
constexpr double largest_offset = 2e-3;

constexpr std::uint64_t keys_per_ray = 32;
constexpr std::uint64_t most_lights_told_apart = 4;

constexpr std::uint64_t key_of(std::size_t ray, Field field) {
    return ray * keys_per_ray + place_of(field);
}
/// The decision whether a branch is grown.
constexpr std::uint64_t key_of(std::size_t ray, RayKind kind) {
    return ray * keys_per_ray + field_count + static_cast<std::uint64_t>(kind);
}
/// The decision whether a light is asked.
constexpr std::uint64_t key_of_light(std::size_t ray, std::size_t light) {
    return ray * keys_per_ray + 27 + std::min<std::uint64_t>(light, most_lights_told_apart);
}

inline Numbers pack(const Vec& v) { return {3, {v.x, v.y, v.z}}; }
inline Numbers pack(const Spectrum& c) { return {3, {c.r, c.g, c.b}}; }
inline Numbers pack(double x) { return {1, {x, 0, 0}}; }
inline Numbers pack(const Indices& i) { return {2, {i.eta1, i.eta2, 0}}; }
inline void unpack(const Numbers& n, Vec& v) { v = {n.x[0], n.x[1], n.x[2]}; }
inline void unpack(const Numbers& n, Spectrum& c) { c = {n.x[0], n.x[1], n.x[2]}; }
inline void unpack(const Numbers& n, double& x) { x = n.x[0]; }
inline void unpack(const Numbers& n, Indices& i) { i = {n.x[0], n.x[1]}; }

/// The size that a point along the ray is relative to.
inline double reach(const Step& step) { return largest_component(step.origin) + abs(step.t); }

/// The earlier of two findings.
inline std::ptrdiff_t first_of(std::ptrdiff_t a, std::ptrdiff_t b) {
    return a < 0 ? b : b < 0 ? a : std::min(a, b);
}

template <class V> void Replay::see(At at, Field field, V& value, double scale, Taint& taint) {
    if (at.ray == none) {
        return;
    }
    Numbers numbers = pack(value);
    see_numbers(at, field, numbers, scale, taint);
    unpack(numbers, value);
}

}  // namespace raytree::check
