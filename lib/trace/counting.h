#pragma once

#include <array>
#include <optional>

#include "trace/recorder.h"

namespace raytree {

/// What tracing took, over one pixel or a whole picture.
struct RayCounts {
    struct OfKind {
        std::size_t rays = 0;
        std::size_t hits = 0;  ///< of shadow rays: those that were stopped
    };
    std::array<OfKind, 4> kinds;                      ///< by RayKind
    std::array<std::size_t, reason_count> skipped{};  ///< rays not sent, by Reason
    std::size_t tests = 0;                            ///< of a ray with a shape

    OfKind& operator[](RayKind kind) { return kinds[static_cast<std::size_t>(kind)]; }
    const OfKind& operator[](RayKind kind) const { return kinds[static_cast<std::size_t>(kind)]; }
    std::size_t rays() const;
    RayCounts& operator+=(const RayCounts& other);
};

/// Counts the rays of the trees that it watches; for one tree at a time also how deep it went and
/// why its weightiest branch ended.
template <class T> class CountingRecorder {
  public:
    static constexpr bool wants_reasons = true;

    struct RayHandle {
        RayKind kind = RayKind::primary;
        T weight = T(1);  ///< largest component
    };

    TestCount tests;
    RayCounts counts;
    int levels = 0;
    Reason ended =
        Reason::no_intersection;  ///< of the leaf with the largest weight, first of equals

    void begin_tree() {
        levels = 0;
        heaviest_leaf_ = T(-1);
    }

    RayHandle start(RayHandle /*parent*/, const RayStart<T>& ray) {
        ++counts[ray.kind].rays;
        levels = max_of(levels, ray.level);
        return {ray.kind, largest_component(ray.weight)};
    }
    void hit(RayHandle handle, const HitEvent<T>&) { ++counts[handle.kind].hits; }
    void shadow(RayHandle, const ShadowEvent<T>& event) {
        ++counts[RayKind::shadow].rays;
        counts[RayKind::shadow].hits += event.blocker ? 1 : 0;
    }
    void skip_light(RayHandle, std::size_t, Reason reason) { skip(reason); }
    void skip_branch(RayHandle, RayKind, Reason reason) { skip(reason); }
    void end(RayHandle handle, const RayEnd<T>& end) {
        if (end.termination && handle.weight > heaviest_leaf_) {
            heaviest_leaf_ = handle.weight;
            ended = *end.termination;
        }
    }

  private:
    void skip(Reason reason) { ++counts.skipped[static_cast<std::size_t>(reason)]; }

    T heaviest_leaf_ = T(-1);
};

}  // namespace raytree
