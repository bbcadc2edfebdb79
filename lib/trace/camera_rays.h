#pragma once

#include "geometry/ray.h"
#include "scene/scene.h"

namespace raytree {

/// The camera's own axes and window in the arithmetic T (model, section 1).
template <class T> class CameraRays {
  public:
    CameraRays(const Camera& camera, PixelSample sample);

    /// The primary ray of pixel (i, j): column from the left, row from the top, both from 0.
    Ray<T> primary(int i, int j) const {
        Ray<T> ray;
        primary(i, j, ray);
        return ray;
    }
    /// The same, written where it stays.
    void primary(int i, int j, Ray<T>& ray) const;

    /// The smallest t that a primary ray of this direction sees.
    T near_along(const Vec3<T>& direction) const {
        return near_ > 0 ? near_ / inner(forward_, direction) : T(0);
    }

    const UnitVec3<T>& right() const { return right_; }      ///< Vx
    const Vec3<T>& up() const { return up_; }                ///< Vy
    const UnitVec3<T>& forward() const { return forward_; }  ///< Vz
    /// The pixel's sample point in eye space, (xp, yp) on the plane at distance 1.
    T xp(int i) const { return fma(static_cast<T>(i) + offset_, pixel_width_, left_); }
    T yp(int j) const { return fma(-(static_cast<T>(j) + offset_), pixel_height_, top_); }

  private:
    Vec3<T> eye_;
    UnitVec3<T> forward_;
    UnitVec3<T> right_;
    Vec3<T> up_;
    T left_, top_, pixel_width_, pixel_height_, offset_, near_;
};

template <class T> CameraRays<T>::CameraRays(const Camera& camera, PixelSample sample)
    : eye_(vector_cast<T>(camera.eye)),
      forward_(UnitVec3<T>::of(vector_cast<T>(camera.look_at) - eye_)),
      right_(UnitVec3<T>::of(outer(forward_.vec(), vector_cast<T>(camera.up)))),
      up_(outer(right_.vec(), forward_.vec())),
      offset_(sample == PixelSample::center ? T(0.5) : T(0)),
      near_(static_cast<T>(camera.near)) {
    const T width = static_cast<T>(camera.width);
    const T height = static_cast<T>(camera.height);
    if (const auto* plane = std::get_if<ImagePlane>(&camera.window)) {
        left_ = static_cast<T>(plane->left);
        top_ = static_cast<T>(plane->top);
        pixel_width_ = (static_cast<T>(plane->right) - left_) / width;
        pixel_height_ = (top_ - static_cast<T>(plane->bottom)) / height;
    } else {
        const T degrees = static_cast<T>(std::get<HorizontalFov>(camera.window).degrees);
        const T half_width = tan(degrees * Real<T>::pi / 360);
        left_ = -half_width;
        top_ = half_width * height / width;
        pixel_width_ = pixel_height_ = 2 * half_width / width;
    }
}

template <class T>
[[gnu::always_inline]] inline void CameraRays<T>::primary(int i, int j, Ray<T>& ray) const {
    const Vec3<T> across = along(Vec3<T>(xp(i) * right_.vec()), yp(j), up_);
    ray.origin = eye_;
    ray.direction = UnitVec3<T>::of(forward_.vec() + across).vec();
    ray.origin_error = 0;
    ray.going = Going::unknown;
}

}  // namespace raytree
