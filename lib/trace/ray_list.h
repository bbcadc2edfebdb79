#pragma once

#include <vector>

#include "trace/tracer.h"

namespace raytree {

/// A ray of a picture and what is asked of it.
template <class T> struct ListedRay {
    Ray<T> ray;
    PrimitiveId leaving = no_primitive;
    Interval<T> interval;
    RayKind kind = RayKind::primary;
};

/// Writes down every ray that the tracer follows, so that the same rays can be asked again of
/// something else: another hierarchy, another arithmetic, a clock.
template <class T> class RayListRecorder {
  public:
    static constexpr bool wants_reasons = false;

    using RayHandle = std::size_t;  ///< a place in `met_`; 0: the eye

    explicit RayListRecorder(const World<T>& world) : world_(world) {}

    NoTestCount tests;
    std::vector<ListedRay<T>> rays;

    void begin_tree() { met_.resize(1); }

    RayHandle start(RayHandle parent, const RayStart<T>& begun) {
        ListedRay<T> listed{begun.ray, met_[parent].on, {}, begun.kind};
        if (begun.kind == RayKind::primary) {
            listed.interval.from = world_.camera.near_along(begun.ray.direction);
        }
        if (world_.max_distance) {
            listed.interval.to = *world_.max_distance - met_[parent].path;
        }
        rays.push_back(listed);
        met_.push_back({no_primitive, met_[parent].path});
        return met_.size() - 1;
    }
    void hit(RayHandle handle, const HitEvent<T>& event) {
        met_[handle].on = event.hit.primitive;
        met_[handle].path += event.hit.t;
    }
    void shadow(RayHandle handle, const ShadowEvent<T>& event) {
        const Vec3<T>& from = event.origin;
        rays.push_back(
            {{from, event.at->towards, 4 * Real<T>::unit_roundoff * largest_component(from)},
             met_[handle].on,
             {T(0), event.at->distance * (1 - 8 * Real<T>::unit_roundoff)},
             RayKind::shadow});
    }
    void skip_light(RayHandle, std::size_t, Reason) {}
    void skip_branch(RayHandle, RayKind, Reason) {}
    void end(RayHandle, const RayEnd<T>&) {}

  private:
    struct Met {
        PrimitiveId on = no_primitive;  ///< the shape that the ray has hit
        T path = 0;                     ///< length from the eye to its hit
    };

    const World<T>& world_;
    std::vector<Met> met_{1};
};

/// The rays of pixel (i, j).
template <class T> std::vector<ListedRay<T>> rays_of_pixel(const World<T>& world, int i, int j);
/// The rays of every `stride`-th pixel of a picture, row by row; `stride` is 1 or more.
template <class T>
std::vector<ListedRay<T>> rays_of_picture(const World<T>& world, std::size_t stride = 1);

extern template std::vector<ListedRay<float>> rays_of_pixel(const World<float>&, int, int);
extern template std::vector<ListedRay<double>> rays_of_pixel(const World<double>&, int, int);
extern template std::vector<ListedRay<float>> rays_of_picture(const World<float>&, std::size_t);
extern template std::vector<ListedRay<double>> rays_of_picture(const World<double>&, std::size_t);

}  // namespace raytree
