#pragma once

#include <string>
#include <vector>

#include "drawing/mesh.h"
#include "drawing/ray_mesh.h"

/// What the lecture draws at a hit: the directions, and their angles from the normal.
namespace raytree::inspector {

/// Words at a place; `out` is another place, towards which they may be moved if there is no room.
struct DrawnWords {
    Point3 at, out;
    std::string text;
    bool strong = false;  ///< not left out while others can be
};

struct AngleDrawing {
    Mesh solid;
    Mesh faint;  ///< partly transparent
    std::vector<DrawnWords> words;
};

struct AngleInput {
    const Document& document;
    const PixelTree& tree;
    std::size_t selected = 0;
    const Extent& extent;
    const View& view;
    const Palette& palette;
    bool angles = true;
    bool ghosts = true;
    const Playback* playback = nullptr;  ///< what it has not come to yet is not drawn
    RayFilter filter = {};               ///< nor the angles of rays that are hidden
};

/// At the selected ray's hit: the angles of the incident ray and of what is reflected and
/// refracted, in degrees from the normal; the refractive indices; under total internal reflection
/// the critical angle; and, as ghosts with their reasons, the rays that were not sent from there.
/// Nothing where the ray hits nothing.
AngleDrawing angle_drawing(const AngleInput& input);

/// Whether one of the rays that were not sent from the ray's hit is drawn as a ghost.
bool has_ghosts(const Scene& scene, const TreeRay<double>& ray, const Playback* playback);

/// The size of what is drawn at a hit, from about 0.5 to 1, where shapes are small on the screen.
double size_at_hit(const Extent& extent, const View& view, const Point3& at);

/// The direction in which light leaves a mirror that it meets in a unit direction `d`.
Point3 reflected(const Point3& d, const Point3& normal);
/// Snell's law for a unit direction that meets a surface with its unit normal on the ray's side;
/// none under total internal reflection.
std::optional<Point3> refracted(const Point3& d, const Point3& normal, double eta1, double eta2);

}  // namespace raytree::inspector
