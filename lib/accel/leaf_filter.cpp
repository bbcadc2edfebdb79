#include "accel/leaf_filter.h"

#include <algorithm>
#include <cmath>

namespace raytree {
namespace {

constexpr std::size_t lanes_read = 8;  ///< whole registers are read, beyond the last item too

/// The normal of a triangle from the product of two edges, and the product of their lengths; 0
/// where it is off by more than 2^-30, or where numbers may have underflowed.
Vec3<double> unit_normal(const Vec3<double>& product, double lengths) {
    const double size = length(product);
    return size > 0x1p-20 * lengths && size > 1e-100 ? product / size : Vec3<double>(0);
}

}  // namespace

LeafFilter::LeafFilter(const ShapeSet<double>& shapes, const WideBvh& bvh) {
    std::array<bool, WideBvh::kinds> has{};
    bvh.for_each_leaf([&](WideBvh::Ref leaf) { has[leaf.kind()] = true; });
    if (!has[triangle] && !has[sphere] && !has[cone]) {
        return;
    }
    const std::size_t items = bvh.items().size();
    scale_ = bvh.scale();
    inverse_scale_ = 1 / scale_;
    floats_.resize(numbers * items + lanes_read);
    const Vec3<double> shift = bvh.center() * scale_;
    const bool near_origin = largest_component(shift) <= 4;
    if (near_origin && holds_exactly(shapes, bvh)) {
        shift_ = shift;
        reach_ = 1 + largest_component(shift);
    } else {
        center_ = bvh.center();
        exact_.resize(has[triangle] || has[sphere] ? own_numbers * items : 0);
    }
    cones_.resize(has[cone] ? items : 0);
    bvh.for_each_leaf([&](WideBvh::Ref leaf) { copy_leaf(shapes, bvh, leaf); });
}

/// Whether the floats of all triangles and spheres, scaled but not moved, are their numbers to the
/// last bit.
bool LeafFilter::holds_exactly(const ShapeSet<double>& shapes, const WideBvh& bvh) const {
    const auto exact = [&](double number) {
        const auto copy = static_cast<float>(number * scale_);
        return static_cast<double>(copy) * inverse_scale_ == number;
    };
    const auto all_exact = [&](const Vec3<double>& v) {
        return exact(v.x) && exact(v.y) && exact(v.z);
    };
    bool all = true;
    bvh.for_each_leaf([&](WideBvh::Ref leaf) {
        for (std::size_t lane = 0; all && lane < leaf.count(); ++lane) {
            const Primitive primitive = shapes[bvh.items()[leaf.first() + lane]];
            if (leaf.kind() == triangle) {
                const auto& [a, b, c] = shapes.triangle(primitive).vertices;
                all = all_exact(a) && all_exact(b) && all_exact(c);
            } else if (leaf.kind() == sphere) {
                const SphereShape<double>& shape = shapes.sphere(primitive);
                all = all_exact(shape.center) && exact(shape.radius);
            }
        }
    });
    return all;
}

void LeafFilter::copy_leaf(const ShapeSet<double>& shapes, const WideBvh& bvh, WideBvh::Ref leaf) {
    const std::size_t n = leaf.count();
    float* const row = &floats_[numbers * leaf.first()];
    for (std::size_t lane = 0; lane < n; ++lane) {
        const std::size_t item = leaf.first() + lane;
        const Primitive primitive = shapes[bvh.items()[item]];
        row[(numbers - 1) * n + lane] = std::bit_cast<float>(bvh.items()[item]);
        if (leaf.kind() == triangle) {
            const auto shape = shapes.triangle(primitive);
            copy(shape, row + lane, n);
            for (std::size_t k = 0; !exact_.empty() && k < own_numbers; ++k) {
                exact_[own_numbers * item + k] = shape.vertices[k / 3][static_cast<int>(k % 3)];
            }
        } else if (leaf.kind() == sphere) {
            const SphereShape<double>& shape = shapes.sphere(primitive);
            for (std::size_t k = 0; k < 3; ++k) {
                const int axis = static_cast<int>(k);
                row[k * n + lane] =
                    static_cast<float>((shape.center[axis] - center_[axis]) * scale_);
                if (!exact_.empty()) {
                    exact_[own_numbers * item + k] = shape.center[axis];
                }
            }
            row[3 * n + lane] = static_cast<float>(shape.radius * scale_);
            if (!exact_.empty()) {
                exact_[own_numbers * item + 3] = shape.radius;
            }
        } else if (leaf.kind() == cone) {
            const ConeShape<double>& shape = cones_[item] = shapes.cone(primitive);
            for (std::size_t k = 0; k < 3; ++k) {
                const int axis = static_cast<int>(k);
                row[k * n + lane] = static_cast<float>((shape.base[axis] - center_[axis]) * scale_);
                row[(3 + k) * n + lane] = static_cast<float>(shape.axis.vec()[axis]);
            }
            const double apex_radius = shape.base_radius + shape.slope * shape.height;
            // Besides, the height and the radius of a sphere around the middle that holds it.
            const double radius = std::max(shape.base_radius, apex_radius);
            row[6 * n + lane] = static_cast<float>(radius * scale_);
            row[7 * n + lane] = static_cast<float>(shape.height * scale_);
            row[8 * n + lane] = static_cast<float>(std::hypot(shape.height / 2, radius) * scale_);
        }
    }
}

void LeafFilter::copy(const TriangleShape<double>& shape, float* lane, std::size_t step) const {
    for (std::size_t k = 0; k < own_numbers; ++k) {
        const int axis = static_cast<int>(k % 3);
        lane[k * step] = static_cast<float>((shape.vertices[k / 3][axis] - center_[axis]) * scale_);
    }
    const auto& [a, b, c] = shape.vertices;
    const Vec3<double> e = (b - a) * scale_, f = (c - a) * scale_;
    const Vec3<double> normal = unit_normal(outer(e, f), length(e) * length(f));
    for (std::size_t k = 0; k < 3; ++k) {
        lane[(9 + k) * step] = static_cast<float>(normal[static_cast<int>(k)]);
    }
    const double extent =
        max_of(largest_component(e), max_of(largest_component(f), largest_component(e - f)));
    lane[12 * step] = static_cast<float>(extent * (1 + 0x1p-20));
}

}  // namespace raytree
