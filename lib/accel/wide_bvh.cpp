#include "accel/wide_bvh.h"

#include <cmath>

namespace raytree {

WideBvh::BoxRay WideBvh::prepare(const Vec3<double>& origin, const Vec3<double>& direction) const {
    constexpr double flattest = 1e-18;
    constexpr double float_roundoff = 0x1p-24;
    constexpr double double_roundoff = 0x1p-53;
    constexpr double scene_radius = 2;  // boxes lie within 1 of the centre on each axis

    BoxRay ray;
    ray.origin = (origin - center_) * scale_;
    ray.scale = scale_;
    double away = largest_component(ray.origin);
    if (away > 2 * scene_radius) {
        away = length(ray.origin);
        const double skipped = away - scene_radius;
        ray.origin = along(ray.origin, skipped, direction);
        ray.start = skipped / scale_;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int a = static_cast<int>(axis);
        const double slope =
            std::copysign(std::max(std::abs(direction[a]), flattest), direction[a]);
        ray.inverse[axis] = static_cast<float>(1 / slope);
        const double inverse = static_cast<double>(ray.inverse[axis]);
        // 8 float roundings for the two products, the difference and the inverse; the rest is what
        // double has lost on the way from a far origin.
        const double reach = std::abs(ray.origin[a]) + 1;
        const double error =
            std::abs(inverse) * (8 * float_roundoff * reach + 16 * double_roundoff * (away + 1));
        ray.near_bias[axis] = static_cast<float>(inverse * ray.origin[a] + error);
        ray.far_bias[axis] = static_cast<float>(inverse * ray.origin[a] - error);
    }
    return ray;
}

}  // namespace raytree
