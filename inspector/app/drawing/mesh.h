#pragma once

#include <cstdint>
#include <vector>

#include "drawing/view.h"
#include "state/palette.h"

/// Triangles and lines with a colour at every corner: what the 3D view consists of, before any
/// library draws it.
namespace raytree::inspector {

struct Paint {
    Ink ink;
    std::uint8_t alpha = 255;
};

struct Mesh {
    std::vector<float> points;            ///< x, y, z
    std::vector<float> normals;           ///< x, y, z, unit
    std::vector<std::uint8_t> colours;    ///< r, g, b, alpha
    std::vector<std::int32_t> triangles;  ///< three places of points each

    std::size_t triangle_count() const { return triangles.size() / 3; }
    std::int32_t add_point(const Point3& p, const Point3& normal, const Paint& paint);
    void add_triangle(std::int32_t a, std::int32_t b, std::int32_t c) {
        triangles.insert(triangles.end(), {a, b, c});
    }
};

struct Lines {
    std::vector<float> points;
    std::vector<std::uint8_t> colours;
    std::vector<std::int32_t> segments;  ///< two places of points each

    std::int32_t add_point(const Point3& p, const Paint& paint);
    void add(const Point3& a, const Point3& b, const Paint& paint) { add(a, paint, b, paint); }
    void add(const Point3& a, const Paint& paint_a, const Point3& b, const Paint& paint_b);
};

/// One end of a tube.
struct TubeEnd {
    Point3 at;
    double radius;
    Paint paint;
};

void add_tube(Mesh& mesh, const TubeEnd& from, const TubeEnd& to, int sides = 8);
/// An arrowhead from its broad end to its tip, closed behind.
void add_cone(Mesh& mesh, const Point3& base, const Point3& tip, double radius, const Paint& paint,
              int sides = 12);
void add_ball(Mesh& mesh, const Point3& centre, double radius, const Paint& paint, int slices = 14);
/// A flat ring across the unit axis.
void add_ring(Mesh& mesh, const Point3& centre, const Point3& axis, double inner, double outer,
              const Paint& paint, int sides = 24);
/// A quadrangle whose corners are given in order.
void add_quad(Mesh& mesh, const Point3& a, const Point3& b, const Point3& c, const Point3& d,
              const Paint& paint);
/// One that has another colour along the edge from c to d.
void add_quad(Mesh& mesh, const Point3& a, const Point3& b, const Point3& c, const Point3& d,
              const Paint& paint, const Paint& far_paint);

/// Two unit vectors that are perpendicular to a unit vector and to each other.
struct Across {
    Point3 u, v;
};
Across across(const Point3& unit);

}  // namespace raytree::inspector
