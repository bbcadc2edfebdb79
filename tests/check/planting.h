#pragma once

#include <string>

#include "check/catalogue.h"
#include "check/check.h"

/// Trees of programs with a mistake of the catalogue, and where to plant it.
namespace raytree::test {

#ifdef __SANITIZE_ADDRESS__
constexpr bool is_slow = true;  // a smaller sample does
#else
constexpr bool is_slow = false;
#endif

struct Spot {
    const char* scene;
    int i, j;
};

inline constexpr Spot spots[] = {
    {"glass-ball", 210, 286},        {"glass-ball", 320, 250},   {"air-bubble", 332, 240},
    {"air-bubble", 237, 247},        {"attenuation", 344, 458},  {"cut-open", 150, 240},
    {"directional-light", 500, 370}, {"ellipsoids", 90, 462},    {"full-tree", 320, 200},
    {"glass-pane-shadow", 420, 375}, {"max-distance", 275, 365}, {"mesh", 340, 280},
    {"mirrors-facing", 485, 165},    {"nested-media", 375, 273}, {"prism", 195, 205},
    {"smooth-triangle", 430, 280},   {"ellipsoids", 300, 240},   {"cones", 360, 140},
};

bool finite(const RayTree<double>& tree);

/// The tree of a program with this mistake; empty where it has numbers that are none.
std::string planted(const check::Checker& checker, const check::MistakeRow& row, const Spot& spot);

}  // namespace raytree::test
