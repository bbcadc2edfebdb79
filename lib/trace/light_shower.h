#pragma once

#include <vector>

#include "trace/world.h"

/// Forward ray casting: rays from a light, followed as light travels, until one happens to reach
/// the eye.
namespace raytree {

struct ShowerOptions {
    std::size_t rays = 1000;  ///< that leave the light
    double eye_radius = 0.1;  ///< of the ball around the eye that counts as the eye, > 0
    int bounces = 3;          ///< surfaces that a ray may meet
    std::size_t kept = 2000;  ///< paths that are written down: the first ones, and all that arrive
};

/// The corners of a ray's way: the light, the surfaces it met, and its end (of a ray that meets
/// nothing more a point far out).
struct ShowerPath {
    std::vector<Vec3<double>> points;
    bool reaches_eye = false;
    bool in_picture = false;  ///< and through the window of the picture
    bool escapes = false;
};

struct LightShower {
    std::size_t rays = 0;
    std::size_t hits = 0;      ///< that met a surface at all
    std::size_t segments = 0;  ///< rays after each bounce counted as well
    std::size_t reach_eye = 0;
    std::size_t in_picture = 0;
    std::vector<ShowerPath> paths;
};

/// Sends rays evenly in all directions (the spherical Fibonacci lattice: González, "Measurement of
/// areas on a sphere using Fibonacci and latitude-longitude lattices", 2010; of a directional light
/// evenly over a disc as wide as the scene), always the same ones. At a surface each goes on in one
/// direction: mirrored or refracted where the material does so most, else scattered by the cosine
/// law, with numbers of the additive recurrence R2 (Roberts, 2018).
LightShower shower(const World<double>& world, std::size_t light, const ShowerOptions& options);

}  // namespace raytree
