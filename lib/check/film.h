#pragma once

#include <cmath>

#include "check/laws.h"

namespace raytree::check {

/// A place on the plane at distance 1 from the eye, in eye space.
struct FilmPoint {
    double x = 0, y = 0;
};

/// Where the window's place (u, v) is, both from 0 to 1 from the upper left corner.
inline FilmPoint film_at(const Place& place, double u, double v) {
    const Camera& camera = place.scene().camera;
    const bool centre = place.scene().settings.pixel_sample == PixelSample::center;
    const double offset = centre ? 0.5 : 0;
    const double width = place.camera.xp(1) - place.camera.xp(0);
    const double height = place.camera.yp(1) - place.camera.yp(0);
    return {place.camera.xp(0) + (u * camera.width - offset) * width,
            place.camera.yp(0) + (v * camera.height - offset) * height};
}

/// The film point of the step's pixel, by the scene's own rule.
inline FilmPoint film_of(const Place& place, const Step& step) {
    return {place.camera.xp(step.pixel_i), place.camera.yp(step.pixel_j)};
}

inline Beam beam_through(const Place& place, FilmPoint at) {
    const auto& camera = place.camera;
    return {place.scene().camera.eye,
            camera.forward().vec() + at.x * camera.right().vec() + at.y * camera.up()};
}

/// Width over height of the picture.
inline double aspect_of(const Place& place) {
    const Camera& camera = place.scene().camera;
    return static_cast<double>(camera.width) / static_cast<double>(camera.height);
}

/// Half the horizontal field of view, in radians; nothing where the scene gives a window.
inline std::optional<double> half_fov(const Place& place) {
    const auto* fov = std::get_if<HorizontalFov>(&place.scene().camera.window);
    return fov ? std::optional(fov->degrees * Real<double>::pi / 360) : std::nullopt;
}

}  // namespace raytree::check
