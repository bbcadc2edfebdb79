#pragma once

#include <array>

#include "drawing/view.h"
#include "state/document.h"

namespace raytree::inspector {

struct Span3 {
    Point3 low{0, 0, 0};
    Point3 high{0, 0, 0};

    Point3 centre() const { return (low + high) * 0.5; }
    double diagonal() const { return length(high - low); }
    void add(const Point3& p);
    bool contains(const Point3& p) const;
    Span3 grown(double by) const;
    std::array<Point3, 8> corners() const;
};

/// What of a scene matters for showing it: what the camera sees of it, without floors and walls
/// that go on far beyond. Sizes of things in the 3D view are measured by it.
struct Extent {
    Span3 seen;
    double diagonal = 1;
    double plane_distance =
        1;                    ///< from the eye, where the picture stands in front of what it shows
    double far_distance = 1;  ///< from the eye, beyond most of what is seen
};
Extent extent_of(const Document& document);

/// Corners of the picture at a distance along the line of sight: top left, top right, bottom right,
/// bottom left.
std::array<Point3, 4> picture_corners(const Document& document, double distance);

/// Where the point of a pixel that is sampled stands on the picture there.
Point3 place_on_picture(const Document& document, Pixel pixel, double distance);

}  // namespace raytree::inspector
