#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "trace/world.h"
#include "tree/derivation.h"

namespace raytree {

/// The crossing (even-odd) test of one polygon for one ray, as one walks it: from the point in the
/// polygon's plane towards larger u, counting the edges that are crossed.
struct CrossingWalk {
    /// An edge of the outline that the walk crosses. Places are in the world.
    struct Crossed {
        std::size_t edge = 0;  ///< from this corner to the next, counted from 0
        double u = 0;          ///< where, in the polygon's own space
        Vec3<double> from{}, to{}, at{};
    };

    std::string object;
    PolygonDerivation test;
    Vec3<double> point{};          ///< where the ray meets the plane
    std::vector<Crossed> crossed;  ///< in the order of the walk
    std::size_t corners = 0;       ///< of the polygon
    bool own_space = false;        ///< the polygon is transformed; `test` is before that

    bool inside() const { return crossed.size() % 2 == 1; }
};

/// Of the polygon or triangle of this name; without one, of that which the ray hits, or else of the
/// polygon whose plane it meets first. Nothing where there is none, and where the ray is parallel
/// to the plane or the plane lies behind it.
std::optional<CrossingWalk> crossing_walk(const World<double>& world, const TreeRay<double>& ray,
                                          std::string_view name = {});

/// Whether the scene has a polygon, or a mesh's triangle, of this name.
bool has_polygon(const World<double>& world, std::string_view name);

}  // namespace raytree
