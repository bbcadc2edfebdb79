#pragma once

#include <array>
#include <bit>
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

    /// So many floats an item. Of a leaf of n items that begins with item `first`, they begin at
    /// numbers * first: n of the first kind, then n of the second, and so on. Triangles: x, y and
    /// z of the first vertex, of the second, of the third, the unit normal (0 where double hardly
    /// tells it: a sliver), the largest extent along an axis; spheres: x, y, z and radius; cones:
    /// the base, the unit axis, the larger radius, the height, the radius of a sphere around all.
    /// The last is the bits of the shape's name: what is met is called by it, and here it comes
    /// with the rest.
    static constexpr std::size_t numbers = 14;
    /// The first of them, which are a triangle's or a sphere's own.
    static constexpr std::size_t own_numbers = 9;

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

    /// The name of a shape that is copied.
    PrimitiveId name_of(WideBvh::Ref leaf, std::size_t lane) const {
        return std::bit_cast<PrimitiveId>(of_leaf(leaf)[(numbers - 1) * leaf.count() + lane]);
    }

    /// The origin of a ray that has been prepared for the boxes, in the space of the copies.
    Vec3<double> origin_of(const WideBvh::BoxRay& ray) const { return ray.origin + shift_; }
    /// At least the largest coordinate of a copy.
    double reach() const { return reach_; }
    /// Bound on the error of the difference of two copies; 0 where they are exact.
    float edge_error() const {
        return exact_.empty() ? 0.0F : 0x1.8p-23F * static_cast<float>(reach_);
    }

    /// The numbers of the triangle or the sphere at a lane of a leaf, to the last bit.
    class Exact {
      public:
        Exact(const LeafFilter& filter, WideBvh::Ref leaf, std::size_t lane)
            : floats_(filter.of_leaf(leaf) + lane),
              doubles_(filter.exact_.data() + own_numbers * (leaf.first() + lane)),
              step_(leaf.count()),
              in_floats_(filter.exact_.empty()),
              inverse_scale_(filter.inverse_scale_) {}
        double operator[](std::size_t k) const {
            return in_floats_ ? static_cast<double>(floats_[k * step_]) * inverse_scale_
                              : doubles_[k];
        }
        Vec3<double> vector(std::size_t k) const {
            return {(*this)[k], (*this)[k + 1], (*this)[k + 2]};
        }

      private:
        const float* floats_;
        const double* doubles_;
        std::size_t step_;
        bool in_floats_;
        double inverse_scale_;
    };

    /// The shapes at `lane` of a leaf of their kind, to the last bit.
    TriangleShape<double> triangle_of(WideBvh::Ref leaf, std::size_t lane) const {
        const Exact of(*this, leaf, lane);
        return {{of.vector(0), of.vector(3), of.vector(6)}};
    }
    SphereShape<double> sphere_of(WideBvh::Ref leaf, std::size_t lane) const {
        const Exact of(*this, leaf, lane);
        return {of.vector(0), of[3]};
    }
    const ConeShape<double>& cone_of(WideBvh::Ref leaf, std::size_t lane) const {
        return cones_[leaf.first() + lane];
    }

    std::size_t bytes() const {
        return floats_.capacity() * sizeof(float) + exact_.capacity() * sizeof(double) +
               cones_.capacity() * sizeof(ConeShape<double>);
    }

  private:
    void copy_leaf(const ShapeSet<double>& shapes, const WideBvh& bvh, WideBvh::Ref leaf);
    void copy(const TriangleShape<double>& shape, float* lane, std::size_t step) const;
    bool holds_exactly(const ShapeSet<double>& shapes, const WideBvh& bvh) const;

    HugePageVector<float> floats_;
    HugePageVector<double> exact_;             ///< own numbers by item; none where floats are exact
    HugePageVector<ConeShape<double>> cones_;  ///< by item; none where there are no cones
    Vec3<double> shift_{0.0};                  ///< of this space against that of the boxes
    Vec3<double> center_{0.0};
    double scale_ = 1, inverse_scale_ = 1;
    double reach_ = 1;
};

}  // namespace raytree
