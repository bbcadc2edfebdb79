#pragma once

#include <array>
#include <span>

#include "accel/wide_bvh.h"
#include "geometry/shape_set.h"

namespace raytree {

/// Float copies of a scene's triangles, spheres and cones, leaf by leaf, with which eight of them
/// are tested at once. The test passes every shape that the ray meets and few others; those it
/// passes are then met in double. So it decides how fast an answer is found and never which.
class LeafFilter {
  public:
    /// What an item of the hierarchy is.
    enum Kind : std::uint8_t { triangle, sphere, cone, other };

    /// Nine floats an item. Of a leaf of n items that begins with item `first`, they begin at
    /// 9 * first: n numbers of the first kind, then n of the second, and so on. Triangles: x, y
    /// and z of the first vertex, of the second, of the third; spheres: x, y, z and radius; cones:
    /// the base, the unit axis, the larger radius.
    static constexpr std::size_t numbers = 9;

    LeafFilter() = default;
    LeafFilter(const ShapeSet<double>& shapes, const WideBvh& bvh);

    static Kind kind_of(const Primitive& primitive) {
        return primitive.transform >= 0                ? other
               : primitive.kind == ShapeKind::triangle ? triangle
               : primitive.kind == ShapeKind::sphere   ? sphere
               : primitive.kind == ShapeKind::cone     ? cone
                                                       : other;
    }

    const float* of_leaf(WideBvh::Ref leaf) const { return &floats_[numbers * leaf.first()]; }

    /// The origin of a ray that has been prepared for the boxes, in the space of the copies.
    Vec3<double> origin_of(const WideBvh::BoxRay& ray) const { return ray.origin + shift_; }
    /// At least the largest coordinate of a copy.
    double reach() const { return reach_; }

    /// The triangle at `lane` of a leaf, to the last bit.
    TriangleShape<double> triangle_of(WideBvh::Ref leaf, std::size_t lane) const;

    std::size_t bytes() const {
        return floats_.capacity() * sizeof(float) + exact_.capacity() * sizeof(double);
    }

  private:
    void copy_leaf(const ShapeSet<double>& shapes, const WideBvh& bvh, WideBvh::Ref leaf);
    bool holds_exactly(const ShapeSet<double>& shapes, const WideBvh& bvh) const;

    HugePageVector<float> floats_;
    HugePageVector<double> exact_;  ///< the vertices, nine numbers an item; none where floats do
    Vec3<double> shift_{0.0};       ///< of this space against that of the boxes
    Vec3<double> center_{0.0};
    double scale_ = 1, inverse_scale_ = 1;
    double reach_ = 1;
};

inline TriangleShape<double> LeafFilter::triangle_of(WideBvh::Ref leaf, std::size_t lane) const {
    TriangleShape<double> shape;
    if (exact_.empty()) {
        const float* const row = of_leaf(leaf) + lane;
        for (std::size_t k = 0; k < numbers; ++k) {
            shape.vertices[k / 3][static_cast<int>(k % 3)] =
                static_cast<double>(row[k * leaf.count()]) * inverse_scale_;
        }
    } else {
        const double* const at = &exact_[numbers * (leaf.first() + lane)];
        for (std::size_t k = 0; k < numbers; ++k) {
            shape.vertices[k / 3][static_cast<int>(k % 3)] = at[k];
        }
    }
    return shape;
}

}  // namespace raytree
