#pragma once

#include <vector>

#include "drawing/mesh.h"

namespace raytree::inspector {

/// Which part of the screen things may cover, and how far away they are there at most, in cells of
/// a few pixels; never too little of it.
class Coverage {
  public:
    explicit Coverage(const View& view);

    void add(const Mesh& mesh);
    /// Whether a ball may stand before any of what has been added.
    bool is_behind(const Point3& centre, double radius) const;

  private:
    struct Corner {
        double x, y, depth;  ///< in the directions of the view's axes, from its eye
    };
    struct Place {
        double x, y;  ///< in cells
    };
    Corner corner(const Point3& p) const;
    Place place(const Corner& c) const;
    static Corner between(const Corner& from, const Corner& to, double depth);
    void add_triangle(const Corner& a, const Corner& b, const Corner& c);
    void mark_line(Place from, Place to, double depth);
    void mark_box(double left, double top, double right, double bottom, double depth);

    Point3 eye_;
    ViewAxes axes_;
    double scale_ = 1;    ///< cells by length at depth 1
    double nearest_ = 0;  ///< depth from which on things are projected
    int columns_ = 1, rows_ = 1;
    std::vector<float> cells_;  ///< the largest depth, row by row; 0 where nothing is
};

}  // namespace raytree::inspector
