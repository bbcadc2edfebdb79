#pragma once

#include <cstddef>
#include <optional>

#include "accel/intersector.h"
#include "trace/reason.h"
#include "trace/shading.h"

/// What the tracer reports while it traces a tree. A recorder is a type with the members of
/// NoRecorder; one whose members are empty costs nothing.
namespace raytree {

template <class T> struct RayStart {
    RayKind kind;
    int level;
    const Ray<T>& ray;
    Rgb<T> weight;
};

template <class T> struct HitEvent {
    Hit<T> hit;
    Vec3<T> point{};
    Vec3<T> normal{};  ///< shading normal, turned as the model says
    bool front = true;
    T cos_incident{};
    const Snell<T>* snell = nullptr;  ///< where the material is transmissive
    Rgb<T> kr, kt;                    ///< as used at this hit
};

template <class T> struct ShadowEvent {
    std::size_t light = 0;
    Vec3<T> origin{};
    const Illumination<T>* at = nullptr;
    std::optional<Hit<T>> blocker;
    Rgb<T> transmittance{T(1)};
    LocalLight<T> adds;
};

template <class T> struct RayEnd {
    T attenuation = T(1);
    Rgb<T> ambient, diffuse, specular, intensity;
    std::optional<Reason> termination;
};

/// Records nothing: what renders pictures.
template <class T> struct NoRecorder {
    /// Whether reasons and the nearest blocker matter to this recorder; what only they need is not
    /// computed otherwise.
    static constexpr bool wants_reasons = false;

    using RayHandle = std::nullptr_t;  ///< how the recorder knows a ray that has started

    NoTestCount tests;

    RayHandle start(RayHandle /*parent*/, const RayStart<T>&) { return nullptr; }
    void hit(RayHandle, const HitEvent<T>&) {}
    void shadow(RayHandle, const ShadowEvent<T>&) {}
    void skip_light(RayHandle, std::size_t /*light*/, Reason) {}
    void skip_branch(RayHandle, RayKind, Reason) {}
    void end(RayHandle, const RayEnd<T>&) {}
};

}  // namespace raytree
