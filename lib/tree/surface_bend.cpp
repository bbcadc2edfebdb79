#include "tree/surface_bend.h"

#include <algorithm>
#include <cmath>

namespace raytree {
namespace {

using Vec = Vec3<double>;

/// The shading normal where the ray, moved aside, meets the surface.
template <class T> Vec3<T> normal_beside(const ShapeSet<T>& shapes, PrimitiveId id,
                                         const Ray<double>& ray, double t, const Vec& aside) {
    const Ray<T> beside{vector_cast<T>(ray.origin) + vector_cast<T>(aside),
                        vector_cast<T>(ray.direction), T(0)};
    return shapes.surface_at(id, beside, T(t)).shading_normal.vec();
}

}  // namespace

SurfaceBend bend_at(const ShapeSet<double>& shapes, PrimitiveId id, const Ray<double>& ray,
                    double t, const Vec& n) {
    const double step = 1e-6 * length(shapes.bounds(id).size());
    SurfaceBend bend;
    const Vec axis = std::abs(n.x) < 0.6 ? Vec(1, 0, 0) : Vec(0, 1, 0);
    bend.tangents[0] = UnitVec3<double>::of(outer(n, axis));
    bend.tangents[1] = outer(n, bend.tangents[0]);
    for (std::size_t k = 0; k < 2; ++k) {
        const Vec aside = step * bend.tangents[k];
        const Vec turn =
            normal_beside(shapes, id, ray, t, aside) - normal_beside(shapes, id, ray, t, -aside);
        // What is left by rounding of the difference itself is no bend.
        if (length(turn) > 1e-9) {
            bend.turns[k] = turn / (2 * step);
            bend.curvature = std::max(bend.curvature, length(bend.turns[k]));
        } else {
            bend.turns[k] = Vec(0, 0, 0);
        }
    }
    return bend;
}

double jump_within(const ShapeSet<Quad>& reference, PrimitiveId id, const Ray<double>& ray,
                   double t, const SurfaceBend& bend, double reach) {
    const Vec3<Quad> here = normal_beside(reference, id, ray, t, Vec(0, 0, 0));
    double jump = 0;
    for (const Vec& tangent : bend.tangents) {
        for (const double side : {reach, -reach}) {
            const Vec aside = side * tangent;
            const Vec turn =
                vector_cast<double>(normal_beside(reference, id, ray, t, aside) - here);
            jump = std::max(jump, length<double>(turn - bend.turn(aside)));
        }
    }
    // A bend of second order is no jump.
    return jump > 2 * bend.curvature * reach ? jump : 0;
}

}  // namespace raytree
