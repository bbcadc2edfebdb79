#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "trace/world.h"
#include "tree/ray_tree.h"

/// How a ray's hit was found, in the steps that one does by hand.
namespace raytree {

/// `A t^2 + B t + C = 0` for a sphere. Where the sphere is transformed, in its own space; t is the
/// distance in the world all the same.
struct SphereDerivation {
    double a = 0;                   ///< d . d
    double b = 0;                   ///< 2 d . (o - c)
    double c = 0;                   ///< (o - c) . (o - c) - r^2
    double discriminant = 0;        ///< B^2 - 4 A C
    std::array<double, 2> roots{};  ///< the smaller first; equal where the ray only touches
    int taken = 0;                  ///< which of them is the hit
};

/// The plane `n . x = offset` of a polygon, and where in it the ray meets the outline.
struct PolygonDerivation {
    Vec3<double> normal{};
    double offset = 0;
    double start = 0;     ///< n . o
    double speed = 0;     ///< n . d
    double t = 0;         ///< (offset - n . o) / (n . d)
    int dropped = 0;      ///< axis of the normal's largest component: 0 is x
    double u = 0, v = 0;  ///< the point's coordinates that are kept, in cyclic order
    int crossings = 0;    ///< of the outline with the half line from the point towards larger u
};

/// An edge of the outline that the half line from the point in the plane towards larger u crosses.
struct OutlineCrossing {
    std::size_t edge = 0;  ///< from this corner to the next, counted from 0
    Vec3<double> at{};     ///< where, in the polygon's own space
};

/// `A t^2 + B t + C = 0` for the surface `|across|^2 = (r + m z)^2` of a cone or cylinder that goes
/// on for ever, z being the height over the base, along the axis, and across what is left of
/// `o + t d - base` without that. A root counts where `0 <= z <= h`.
struct ConeDerivation {
    double radius = 0;  ///< r, at the base
    double slope = 0;   ///< m, by which the radius grows with z; 0 for a cylinder
    double height = 0;  ///< h
    double a = 0;       ///< d_across . d_across - (m d_z)^2
    double b = 0;       ///< 2 (d_across . o_across - m d_z (r + m o_z))
    double c = 0;       ///< o_across . o_across - (r + m o_z)^2
    double discriminant = 0;
    std::array<double, 2> roots{};    ///< the smaller first; the second is NaN where A is 0
    std::array<double, 2> heights{};  ///< z of each root
    int taken = 0;                    ///< which of them is the hit
};

using HitDerivation =
    std::variant<std::monostate, SphereDerivation, PolygonDerivation, ConeDerivation>;

/// A shape that the ray would meet if nothing stopped it.
struct AlongRay {
    std::string object;
    double t = 0;
    bool taken = false;  ///< the hit itself, or of a shadow ray what blocks it first
};

struct Medium {
    std::string material;
    double ior = 1;
};

struct Derivation {
    HitDerivation how;
    bool starts_on_it = false;    ///< the ray leaves the very shape that it meets
    bool own_space = false;       ///< the shape is transformed
    std::vector<AlongRay> along;  ///< in the order of t; of a shadow ray up to its light
    std::vector<Medium> media;    ///< that the ray is in, the one entered last at the end
};

/// `tree` must have been traced in this world.
Derivation derive(const World<double>& world, const RayTree<double>& tree, std::size_t ray);

SphereDerivation derive_sphere(const Sphere& sphere, const Ray<double>& ray, double t);
ConeDerivation derive_cone(const Cone& cone, const Ray<double>& ray, double t);
PolygonDerivation derive_polygon(std::span<const Vec3<double>> vertices, const Ray<double>& ray);

/// Those that the crossing test counts, in the order of the half line.
std::vector<OutlineCrossing> outline_crossings(std::span<const Vec3<double>> vertices,
                                               const PolygonDerivation& polygon);

/// The corners of a polygon, or of a mesh's triangle `part`, in its own space; none of another
/// shape.
std::vector<Vec3<double>> corners_of(const Shape& shape, int part);

/// The shape that goes by a name in the tree; no_primitive where there is none.
PrimitiveId primitive_named(const World<double>& world, std::string_view name);

}  // namespace raytree
