#pragma once

#include <optional>

#include "drawing/extent.h"
#include "state/thing.h"

/// What lies under a place on the screen, besides rays (see path_at).
namespace raytree::inspector {

/// The light whose mark is nearest, if one is within `reach` pixels.
std::optional<Thing> light_at(const Scene& scene, const Extent& extent, const View& view, double x,
                              double y, double reach);

/// The object that is seen there, were all solid, behind what the view cuts away.
std::optional<Thing> object_at(const Document& document, const View& view, double x, double y);

/// Whether something stands before a point, were all solid, behind what the view cuts away.
bool is_hidden(const Document& document, const View& view, const Point3& p);

/// A point of an object that is seen, were all solid: the first one looking from the view's middle
/// outwards, place by place of a coarse grid. None where it is hidden, outside, or small.
std::optional<Point3> seen_point(const Document& document, const View& view, Thing object);

/// The corners of the box around a thing that is to be seen when it is fitted.
std::vector<Point3> corners_of(const Document& document, const Extent& extent, Thing thing);

}  // namespace raytree::inspector
