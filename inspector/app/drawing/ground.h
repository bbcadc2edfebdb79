#pragma once

#include <array>
#include <vector>

#include "drawing/extent.h"

namespace raytree::inspector {

/// How flat shapes that go on far beyond the view end: around the scene's middle they fade out, up
/// to a round rim.
class Ground {
  public:
    using Triangle = std::array<Point3, 3>;
    using Segment = std::array<Point3, 2>;

    explicit Ground(const Extent& extent);

    /// How firm a shape is at a place: 1 in the middle of the scene, 0 from the rim on.
    double firmness(const Point3& p) const;
    /// Whether a triangle lies where everything is firm.
    bool is_firm(const Triangle& triangle) const;
    /// What lies within the rim, in facets that are small enough to follow the fading.
    std::vector<Triangle> facets(const Triangle& triangle, const Point3& normal) const;
    /// The part of a line within the rim, in pieces that follow the fading.
    std::vector<Segment> pieces(const Point3& from, const Point3& to) const;
    /// The part of a square grid in the triangle's plane that lies in it, within the rim.
    std::vector<Segment> grid(const Triangle& triangle, const Point3& normal) const;

  private:
    double finest() const { return 0.06 * diagonal_; }

    Point3 middle_;
    double diagonal_;
};

}  // namespace raytree::inspector
