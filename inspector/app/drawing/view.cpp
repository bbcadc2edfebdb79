#include "drawing/view.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace raytree::inspector {
namespace {

double half_height(const View& view) { return std::tan(view.fov_degrees * std::numbers::pi / 360); }

/// Points behind the viewer are treated as if this far in front, relative to the target.
constexpr double nearest = 1e-3;

Point3 rotated(const Point3& v, const Point3& unit_axis, double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    return v * std::cos(angle) + glm::cross(unit_axis, v) * std::sin(angle) +
           unit_axis * (glm::dot(unit_axis, v) * (1 - std::cos(angle)));
}

}  // namespace

ViewAxes axes_of(const View& view) {
    const Point3 forward = glm::normalize(view.target - view.eye);
    Point3 right = glm::cross(forward, view.up);
    if (glm::length(right) < 1e-9 * glm::length(view.up)) {
        right = glm::cross(forward, std::abs(forward.x) < 0.9 ? Point3(1, 0, 0) : Point3(0, 1, 0));
    }
    right = glm::normalize(right);
    return {right, glm::cross(right, forward), forward};
}

std::optional<ScreenPoint> project(const View& view, const Point3& p) {
    const ViewAxes axes = axes_of(view);
    const Point3 to = p - view.eye;
    const double depth = glm::dot(to, axes.forward);
    if (depth <= nearest * glm::length(view.target - view.eye)) {
        return std::nullopt;
    }
    const double scale = view.height / (2 * half_height(view) * depth);
    return ScreenPoint{view.width / 2.0 + glm::dot(to, axes.right) * scale,
                       view.height / 2.0 - glm::dot(to, axes.up) * scale, depth};
}

Point3 direction_through(const View& view, double x, double y) {
    const ViewAxes axes = axes_of(view);
    const double pixel = 2 * half_height(view) / view.height;  // at distance 1
    return glm::normalize(axes.forward + axes.right * ((x - view.width / 2.0) * pixel) -
                          axes.up * ((y - view.height / 2.0) * pixel));
}

double length_per_pixel(const View& view, const Point3& p) {
    const Point3 sight = view.target - view.eye;
    const double distance = glm::length(sight);
    const double depth = std::max(glm::dot(p - view.eye, sight) / distance, nearest * distance);
    return 2 * depth * half_height(view) / view.height;
}

View orbited(View view, double right_degrees, double up_degrees) {
    const Point3 up = glm::normalize(view.up);
    const ViewAxes axes = axes_of(view);
    const double now =
        std::asin(std::clamp(-glm::dot(axes.forward, up), -1.0, 1.0)) * 180 / std::numbers::pi;
    const double tilt = std::clamp(now + up_degrees, -89.0, 89.0) - now;
    Point3 back = rotated(view.eye - view.target, axes.right, -tilt);
    back = rotated(back, up, -right_degrees);
    view.eye = view.target + back;
    return view;
}

View panned(View view, double right_pixels, double up_pixels) {
    const ViewAxes axes = axes_of(view);
    const double length = length_per_pixel(view, view.target);
    const Point3 by = axes.right * (right_pixels * length) + axes.up * (up_pixels * length);
    view.eye -= by;
    view.target -= by;
    return view;
}

View zoomed(View view, double factor) {
    view.eye = view.target + (view.eye - view.target) / factor;
    view.cut /= factor;
    return view;
}

View fitted(View view, std::span<const Point3> points, double margin) {
    if (points.empty()) {
        return view;
    }
    const ViewAxes axes = axes_of(view);
    const double v = half_height(view) * (1 - margin);
    const double h = v * view.width / std::max(1, view.height);
    // Each point gives a half space in which the eye must lie, on every side of the screen: the eye
    // is as near as all of them let it be (the frustum's four planes pushed against the points).
    double left = -1e300, right = -1e300, top = -1e300, bottom = -1e300, front = 1e300;
    double back = -1e300;
    for (const Point3& p : points) {
        const double x = glm::dot(p, axes.right), y = glm::dot(p, axes.up);
        const double z = glm::dot(p, axes.forward);
        right = std::max(right, x - h * z);
        left = std::max(left, -x - h * z);
        top = std::max(top, y - v * z);
        bottom = std::max(bottom, -y - v * z);
        front = std::min(front, z);
        back = std::max(back, z);
    }
    const double x = (right - left) / 2, y = (top - bottom) / 2;
    double z = std::min(-(right + left) / (2 * h), -(top + bottom) / (2 * v));
    z = std::min(z, front - 0.02 * (back - front) - 1e-9);
    view.eye = axes.right * x + axes.up * y + axes.forward * z;
    view.target = view.eye + axes.forward * std::max((front + back) / 2 - z, 1e-6);
    view.cut = 0;
    return view;
}

}  // namespace raytree::inspector
