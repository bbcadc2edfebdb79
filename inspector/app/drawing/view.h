#pragma once

#include <optional>
#include <span>

#include "math/vector.h"

/// From where the 3D view is looked at, and what follows from it. Plain numbers: no VTK, no Qt.
namespace raytree::inspector {

using Point3 = Vec3<double>;

/// A perspective view. `up` need not be perpendicular to the line of sight; orbiting turns about
/// it.
struct View {
    Point3 eye{0, 0, 5};
    Point3 target{0, 0, 0};
    Point3 up{0, 1, 0};
    double fov_degrees = 30;  ///< vertical, the full angle
    int width = 1;            ///< in pixels
    int height = 1;
    double cut = 0;  ///< how far from the eye shapes are cut away; 0: nowhere
    int foot = 34;  ///< pixels along the lower edge that the legend covers: nothing is fitted there

    friend bool operator==(const View&, const View&) = default;
};

/// Unit vectors to the right of the picture, upwards, and away from the viewer.
struct ViewAxes {
    Point3 right, up, forward;
};
ViewAxes axes_of(const View& view);

struct ScreenPoint {
    double x = 0;      ///< pixels from the left
    double y = 0;      ///< pixels from the top
    double depth = 0;  ///< along the line of sight, in length units
};
/// None behind the viewer.
std::optional<ScreenPoint> project(const View& view, const Point3& p);

/// The unit direction from the eye through a place on the screen.
Point3 direction_through(const View& view, double x, double y);

/// How long a pixel is at a point: what is that long there is one pixel long on the screen.
double length_per_pixel(const View& view, const Point3& p);

View orbited(View view, double right_degrees, double up_degrees);
View panned(View view, double right_pixels, double up_pixels);
/// Nearer by a factor: 2 doubles the size of the target.
View zoomed(View view, double factor);

/// The view in the same direction in which the points fill the screen, but for a margin.
View fitted(View view, std::span<const Point3> points, double margin = 0.08);

}  // namespace raytree::inspector
