#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>

#include "scene/input_error.h"
#include "trace/media.h"
#include "trace/recorder.h"
#include "trace/world.h"

namespace raytree {

/// What a scene's plan says that the tracer is compiled for: where a fact is false, nothing is
/// done for it, not even a question.
struct Facts {
    bool reflective = true;
    bool transmissive = true;
    bool attenuated = true;
};

/// The one tracer: follows a pixel's ray tree depth first and evaluates it bottom up, in the
/// arithmetic T, telling `Recorder` what it does. `facts` must hold for the world's scene.
template <class T, class Recorder, Facts facts = Facts{}> class Tracer {
  public:
    Tracer(const World<T>& world, Recorder& recorder)
        : world_(world), settings_(world.scene().settings), recorder_(recorder) {}

    /// The intensity of pixel (i, j), which must lie in the picture. Throws InputError where a
    /// weight or an intensity grows beyond the range of T.
    Rgb<T> trace_pixel(int i, int j) { return trace_pixel(i, j, primary(i, j), nullptr); }

    /// The ray of pixel (i, j) as the world's shapes are asked about it.
    Query<T> primary(int i, int j) const {
        Query<T> query;
        query.ray = world_.camera.primary(i, j);
        query.interval.from = world_.camera.near_along(query.ray.direction);
        if (world_.max_distance) {
            query.interval.to = *world_.max_distance;
        }
        return query;
    }

    /// The same where `query` is the pixel's and has been asked already, together with others:
    /// `hit` is the answer, or null.
    Rgb<T> trace_pixel(int i, int j, const Query<T>& query, const Hit<T>* hit) {
        rays_ = 0;
        finite_ = true;
        Branch primary;
        primary.start.ray = query.ray;
        primary.interval = query.interval;
        primary.known = hit;
        const Rgb<T> intensity = trace(primary, RayHandle{}).intensity;
        if (!finite_ || !isfinite(intensity)) {
            throw InputError("", "pixel " + std::to_string(i) + "," + std::to_string(j),
                             "the intensities of its tree grow beyond the largest number of this "
                             "precision; lower kr, kt, or the intensity of the lights");
        }
        return intensity;
    }

  private:
    using RayHandle = typename Recorder::RayHandle;

    /// A ray about to be followed.
    struct Branch {
        RayStart<T> start;
        PrimitiveId leaving = no_primitive;
        Interval<T> interval;
        T path = 0;  ///< length from the eye to its start
        Media media;
        const Hit<T>* known = nullptr;  ///< what it meets, where that is known
    };
    struct Result {
        Rgb<T> intensity;
        T attenuation = 1;  ///< f of the distance to its hit
    };
    /// A hit with all that its illumination and its branches need.
    struct Node {
        const Branch& branch;
        RayHandle handle;
        Hit<T> hit;
        SurfacePoint<T> surface;
        Vec3<T> normal;  ///< n of the model
        bool front = true;
        std::uint32_t material_id = 0;
        const WorldMaterial<T>& material;
        Snell<T> snell;
        Rgb<T> kr, kt;
        T attenuation = 1;
        RayEnd<T> end;
    };

    Result trace(const Branch& branch, RayHandle parent);
    Result miss(const Branch& branch, RayHandle handle);
    Result meet(const Branch& branch, RayHandle handle, const Hit<T>& hit);
    static Ray<T> onwards(const Node& node, const Vec3<T>& direction, bool outwards);
    void refract(Node& node) const;
    void light(Node& node);
    void shine(Node& node, std::size_t light, const Illumination<T>& at);
    Rgb<T> transmitted(const Ray<T>& ray, PrimitiveId leaving, T distance,
                       std::optional<Hit<T>>& blocker);
    std::optional<Reason> why_not(const Node& node, RayKind kind, const Rgb<T>& weight) const;
    std::optional<Reason> grow(Node& node, RayKind kind);

    const World<T>& world_;
    const Settings& settings_;
    Recorder& recorder_;
    std::size_t rays_ = 0;
    bool finite_ = true;
};

template <class T, class Recorder, Facts facts>
auto Tracer<T, Recorder, facts>::trace(const Branch& branch, RayHandle parent) -> Result {
    ++rays_;
    const RayHandle handle = recorder_.start(parent, branch.start);
    Interval<T> interval = branch.interval;
    if (world_.max_distance) {
        interval.to = *world_.max_distance - branch.path;
    }
    if (branch.known) {
        const Hit<T>& hit = *branch.known;
        return hit.primitive != no_primitive ? meet(branch, handle, hit) : miss(branch, handle);
    }
    const auto hit =
        world_.shapes.closest(branch.start.ray, branch.leaving, interval, recorder_.tests);
    return hit ? meet(branch, handle, *hit) : miss(branch, handle);
}

template <class T, class Recorder, Facts facts>
auto Tracer<T, Recorder, facts>::miss(const Branch& branch, RayHandle handle) -> Result {
    const bool primary = branch.start.kind == RayKind::primary;
    RayEnd<T> end;
    end.intensity = primary ? world_.background : world_.secondary_background;
    end.termination = world_.max_distance ? Reason::max_distance : Reason::no_intersection;
    recorder_.end(handle, end);
    return {end.intensity, T(1)};
}

template <class T, class Recorder, Facts facts>
auto Tracer<T, Recorder, facts>::meet(const Branch& branch, RayHandle handle, const Hit<T>& hit)
    -> Result {
    const Vec3<T>& d = branch.start.ray.direction;
    const std::size_t object = world_.shapes.shapes()[hit.primitive].object;
    const std::size_t material = world_.scene().objects[object].material;
    Node node{branch,
              handle,
              hit,
              world_.shapes.shapes().surface_at(hit.primitive, branch.start.ray, hit.t),
              {},
              true,
              static_cast<std::uint32_t>(material),
              world_.materials[material],
              {},
              {},
              {},
              T(1),
              {}};
    node.front = inner(d, node.surface.geometric_normal) < 0;
    node.normal =
        node.front ? node.surface.shading_normal.vec() : -node.surface.shading_normal.vec();
    node.kr = node.material.kr;
    node.kt = node.material.kt;
    if (facts.attenuated && branch.start.kind != RayKind::primary) {
        node.attenuation = world_.attenuation.at(hit.t);
    }
    if (facts.transmissive && node.material.transmissive) {
        refract(node);
    }
    recorder_.hit(handle, {hit, node.surface.point, node.normal, node.front, -inner(d, node.normal),
                           node.material.transmissive ? &node.snell : nullptr, node.kr, node.kt});

    node.end.attenuation = node.attenuation;
    node.end.ambient = node.material.ambient;
    light(node);
    node.end.intensity = node.end.ambient + node.end.diffuse + node.end.specular;
    const auto not_reflected = grow(node, RayKind::reflected);
    const auto not_refracted = grow(node, RayKind::refracted);
    if (not_reflected && not_refracted) {
        const Reason later = std::max(*not_reflected, *not_refracted);
        node.end.termination = later <= Reason::not_transmissive ? Reason::opaque : later;
    }
    recorder_.end(handle, node.end);
    return {node.end.intensity, node.attenuation};
}

/// A ray that leaves the hit to the outer or the inner side of its surface.
template <class T, class Recorder, Facts facts>
Ray<T> Tracer<T, Recorder, facts>::onwards(const Node& node, const Vec3<T>& direction,
                                           bool outwards) {
    const Vec3<T>& point = node.surface.point;
    return {point, direction, 4 * Real<T>::unit_roundoff * largest_component(point),
            outwards ? Going::outwards : Going::inwards};
}

/// Which media meet here, and whether the ray can pass (model, "Media").
template <class T, class Recorder, Facts facts>
void Tracer<T, Recorder, facts>::refract(Node& node) const {
    const auto index_of = [&](const Media& media) {
        return media.empty() ? T(1) : world_.materials[media.last()].ior;
    };
    T outside = index_of(node.branch.media);
    if (!node.front) {
        Media beyond = node.branch.media;
        beyond.leave(node.material_id);
        outside = index_of(beyond);
    }
    const T inside = node.material.ior;
    node.snell = snell(node.front ? outside : inside, node.front ? inside : outside,
                       node.branch.start.ray.direction, node.normal);
    if (node.snell.total_reflection() &&
        settings_.total_internal_reflection == TotalReflection::reflect) {
        node.kr += node.kt;
    }
}

template <class T, class Recorder, Facts facts> void Tracer<T, Recorder, facts>::light(Node& node) {
    if (!Recorder::wants_reasons && !node.material.lit) {
        return;
    }
    for (std::size_t k = 0; k < world_.lights.size(); ++k) {
        const Illumination<T> at = illuminate(world_.lights[k], node.surface.point, node.normal);
        if (!at.in_front()) {
            recorder_.skip_light(node.handle, k, Reason::light_behind_surface);
        } else if (!node.material.lit) {
            recorder_.skip_light(node.handle, k, Reason::surface_unlit);
        } else {
            shine(node, k, at);
        }
    }
}

template <class T, class Recorder, Facts facts>
void Tracer<T, Recorder, facts>::shine(Node& node, std::size_t light, const Illumination<T>& at) {
    ShadowEvent<T> shadow;
    shadow.light = light;
    shadow.origin = node.surface.point;
    shadow.at = &at;
    if (settings_.shadows != ShadowMode::none) {
        ++rays_;
        const Ray<T> ray = onwards(node, at.towards, node.front);
        shadow.transmittance = transmitted(ray, node.hit.primitive, at.distance, shadow.blocker);
    }
    if (!is_zero(shadow.transmittance)) {
        shadow.adds =
            local_light(settings_.specular_model, node.material, world_.lights[light], at,
                        node.normal, node.branch.start.ray.direction, shadow.transmittance);
        node.end.diffuse += shadow.adds.diffuse;
        node.end.specular += shadow.adds.specular;
    }
    if (settings_.shadows != ShadowMode::none) {
        recorder_.shadow(node.handle, shadow);
    }
}

/// How much of a light comes through, and which surface stops it.
template <class T, class Recorder, Facts facts>
Rgb<T> Tracer<T, Recorder, facts>::transmitted(const Ray<T>& ray, PrimitiveId leaving, T distance,
                                               std::optional<Hit<T>>& blocker) {
    // What is as far as the light within rounding is where the light is, not in between.
    const Interval<T> between{T(0), distance * (1 - 8 * Real<T>::unit_roundoff)};
    if (settings_.shadows == ShadowMode::opaque) {
        if constexpr (Recorder::wants_reasons) {
            blocker = world_.shapes.closest(ray, leaving, between, recorder_.tests);
            return Rgb<T>(blocker ? T(0) : T(1));
        } else {
            return Rgb<T>(world_.shapes.any(ray, leaving, between, recorder_.tests) ? T(0) : T(1));
        }
    }
    Rgb<T> through(T(1));
    for (const Hit<T>& hit : world_.shapes.all(ray, leaving, between, recorder_.tests)) {
        const std::size_t object = world_.shapes.shapes()[hit.primitive].object;
        through *= world_.materials[world_.scene().objects[object].material].kt;
        if (is_zero(through)) {
            blocker = hit;
            break;
        }
    }
    return through;
}

/// The first reason in the model's order for which a branch is not grown, if there is one.
template <class T, class Recorder, Facts facts>
std::optional<Reason> Tracer<T, Recorder, facts>::why_not(const Node& node, RayKind kind,
                                                          const Rgb<T>& weight) const {
    const bool reflected = kind == RayKind::reflected;
    if (is_zero(reflected ? node.kr : node.kt)) {
        return reflected ? Reason::not_reflective : Reason::not_transmissive;
    }
    if (!reflected && node.snell.total_reflection()) {
        return Reason::total_internal_reflection;
    }
    if (node.branch.start.level >= settings_.max_depth) {
        return Reason::max_depth;
    }
    if (largest_component(weight) < world_.min_weight) {
        return Reason::low_intensity;
    }
    if (rays_ >= settings_.ray_budget) {
        return Reason::ray_budget;
    }
    return std::nullopt;
}

/// Follows a branch and adds its share to the hit's intensity, or says why not.
template <class T, class Recorder, Facts facts>
std::optional<Reason> Tracer<T, Recorder, facts>::grow(Node& node, RayKind kind) {
    const bool reflected = kind == RayKind::reflected;
    if (reflected ? !facts.reflective : !facts.transmissive) {
        const Reason never = reflected ? Reason::not_reflective : Reason::not_transmissive;
        recorder_.skip_branch(node.handle, kind, never);
        return never;
    }
    const Rgb<T>& k = reflected ? node.kr : node.kt;
    const Rgb<T> weight = node.attenuation * (k * node.branch.start.weight);
    finite_ = finite_ && isfinite(weight);
    const auto reason = why_not(node, kind, weight);
    if (reason) {
        recorder_.skip_branch(node.handle, kind, *reason);
        return reason;
    }
    const Vec3<T>& d = node.branch.start.ray.direction;
    const UnitVec3<T> direction = reflected ? reflected_direction(d, node.normal)
                                            : refracted_direction(node.snell, d, node.normal);
    Branch next{{kind, node.branch.start.level + 1,
                 onwards(node, direction.vec(), node.front == reflected), weight},
                node.hit.primitive,
                {},
                node.branch.path + node.hit.t,
                node.branch.media,
                nullptr};
    if (!reflected) {
        if (node.front) {
            next.media.enter(node.material_id);
        } else {
            next.media.leave(node.material_id);
        }
    }
    const Result result = trace(next, node.handle);
    node.end.intensity += result.attenuation * (k * result.intensity);
    return std::nullopt;
}

}  // namespace raytree
