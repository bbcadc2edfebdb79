#pragma once

#include <span>
#include <vector>

#include "drawing/ray_paths.h"

/// The views that a user can ask for. Each has the size of the view that it is asked from.
namespace raytree::inspector {

/// Where the camera is, looking where it looks, all of its picture with its frame in view.
View camera_view(const Document& document, const Extent& extent, const View& now);

/// From the right side and a little from behind the eye: eye, picture, and the rays around the
/// scene's middle fill the screen.
View side_view(const Document& document, const Extent& extent, const std::vector<RayPath>& paths,
               const View& now);

/// Straight onto the plane of incidence at a hit, its surface level and its normal upright: the ray
/// comes from the left, as the lecture draws it. The shape that is hit fills about half of the
/// screen, unless it is large or very small beside the scene. Solid shapes are cut open along the
/// plane: what stands before it hides neither the hit nor the rays inside.
View hit_view(const Document& document, const TreeRay<double>& ray, const Extent& extent,
              const View& now);

/// In the direction of `now`, such that the points fill the screen above the legend.
View fitted_above_legend(const View& now, std::span<const Point3> points, double margin = 0.08);

}  // namespace raytree::inspector
