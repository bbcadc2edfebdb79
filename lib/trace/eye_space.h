#pragma once

#include "trace/camera_rays.h"

namespace raytree {

/// The eye's own coordinates (model, section 1): x along Vx, y along Vy, z along Vz, the eye at 0;
/// left-handed, as in the lecture. Lengths and angles are those of the world.
template <class T> class EyeSpace {
  public:
    EyeSpace(const Camera& camera, PixelSample sample)
        : axes_(camera, sample), eye_(vector_cast<T>(camera.eye)) {}

    Vec3<T> point(const Vec3<T>& in_world) const { return direction(in_world - eye_); }
    Vec3<T> direction(const Vec3<T>& in_world) const {
        return {inner(axes_.right(), in_world), inner(axes_.up(), in_world),
                inner(axes_.forward(), in_world)};
    }
    Vec3<T> point_in_world(const Vec3<T>& in_eye_space) const {
        const Vec3<T> across =
            along(Vec3<T>(in_eye_space.x * axes_.right().vec()), in_eye_space.y, axes_.up());
        return eye_ + along(across, in_eye_space.z, axes_.forward().vec());
    }

  private:
    CameraRays<T> axes_;
    Vec3<T> eye_;
};

}  // namespace raytree
