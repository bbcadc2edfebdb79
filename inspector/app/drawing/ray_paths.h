#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "drawing/extent.h"
#include "state/state.h"

namespace raytree::inspector {

/// A ray as it is drawn: a straight way with a beginning and an end.
struct RayPath {
    enum class End {
        hit,      ///< on a surface that it meets
        open,     ///< it meets nothing: it fades out, its node is hollow
        light,    ///< it arrives at a light
        blocked,  ///< a shadow ray, on the surface that stops it
    };

    std::size_t ray = 0;
    RayLook look = RayLook::primary;
    Point3 from, to;
    double weight = 1;  ///< of the pixel, the largest channel, 0 to 1
    End end = End::hit;
    bool fades = false;  ///< it goes on beyond what is drawn of it
    bool graft = false;  ///< only the tree has it that the shown one is compared with

    bool dashed() const { return graft || look == RayLook::lit || look == RayLook::blocked; }
};

/// The rays of a tree that are not hidden as they are drawn, at most `most` of them: then those
/// that weigh most.
std::vector<RayPath> ray_paths(const PixelTree& tree, const Extent& extent, const RayFilter& filter,
                               std::size_t most = 100'000);

/// The path that is drawn nearest to a place on the screen, if one is within `reach` pixels.
std::optional<std::size_t> path_at(const std::vector<RayPath>& paths, const View& view, double x,
                                   double y, double reach);

/// The ends of a path on the screen, what lies behind the viewer cut off; none where all does.
std::optional<std::pair<ScreenPoint, ScreenPoint>> on_screen(const RayPath& path, const View& view);

/// What is to be seen when the whole tree is, or one ray. Far ends are drawn in.
std::vector<Point3> points_of(const std::vector<RayPath>& paths, const Extent& extent);

}  // namespace raytree::inspector
