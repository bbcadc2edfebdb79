#pragma once

#include <span>

#include "math/vector.h"

namespace raytree {

/// How flat the polygon of some vertices is. All of it is relative to `extent`.
struct Planarity {
    double extent = 0;      ///< diagonal of the vertices' bounding box, in length units
    double area = 0;        ///< of the polygon as seen along its normal, in units of extent^2
    Vec3<double> normal{};  ///< Newell's, unit length; 0 where the area is 0
    double off_plane = 0;   ///< farthest vertex from the plane through the mean, of the extent

    /// Smaller areas are what rounding leaves of vertices on one line.
    static constexpr double least_area = 1e-12;
    static constexpr double most_off_plane = 1e-6;

    bool has_area() const { return area > least_area; }
    bool is_planar() const { return off_plane <= most_off_plane; }
};

/// Of three or more finite vertices in order. Where they are so far apart that their extent is not
/// finite, area is 0.
Planarity planarity_of(std::span<const Vec3<double>> vertices);

}  // namespace raytree
