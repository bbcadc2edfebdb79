#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "scene/input_error.h"
#include "trace/media.h"
#include "trace/recorder.h"
#include "trace/world.h"

namespace raytree {

/// What a scene's plan says that the tracer is compiled for: where a fact is false, nothing is
/// done for it, not even a question. The last two are no facts but ways, which can be turned off to
/// see what they are worth; the intensities do not depend on them.
struct Facts {
    bool reflective = true;
    bool transmissive = true;
    bool attenuated = true;
    ShapeFacts shapes{};
    bool spare_shadow_rays = true;  ///< none to a light that cannot shine, nor from what is unlit
    bool try_last_occluder = true;  ///< of each light, before all shapes are asked
};

/// What is known of a pixel's primary ray that has been asked about together with others.
template <class T> struct PrimaryAnswer {
    const Query<T>* query = nullptr;
    Hit<T> hit;  ///< no_primitive: none; and nothing of what follows
    std::optional<SurfacePoint<T>> surface;
    Vec3<T> normal{};  ///< n of the model
    bool front = true;
    /// By light: what it does here, and whether it is hidden; empty where that has not been asked.
    std::span<Illumination<T>> lights;
    std::span<std::uint8_t> hidden;
};

/// The media that a ray is in, where no ray is ever in one.
struct NoMedia {};

/// The one tracer: follows a pixel's ray tree depth first and evaluates it bottom up, in the
/// arithmetic T, telling `Recorder` what it does. `facts` must hold for the world's scene.
template <class T, class Recorder, Facts facts = Facts{}> class Tracer {
  public:
    Tracer(const World<T>& world, Recorder& recorder)
        : world_(world),
          settings_(world.scene().settings),
          recorder_(recorder),
          last_occluder_(world.lights.size(), no_primitive) {}

    /// The intensity of pixel (i, j), which must lie in the picture. Throws InputError where a
    /// weight or an intensity grows beyond the range of T.
    Rgb<T> trace_pixel(int i, int j) {
        Query<T> query;
        primary(i, j, query);
        return trace_pixel(i, j, query, nullptr);
    }

    /// The same where the pixel's primary ray has been asked already.
    Rgb<T> trace_pixel(int i, int j, const PrimaryAnswer<T>& answer) {
        if (!Recorder::wants_reasons && answer.hit.primitive == no_primitive) {
            return world_.background;
        }
        return trace_pixel(i, j, *answer.query, &answer);
    }

    /// The ray of pixel (i, j) as the world's shapes are asked about it. Like all queries it is
    /// written where it stays: copied at once it would wait for its own numbers.
    void primary(int i, int j, Query<T>& query) const {
        world_.camera.primary(i, j, query.ray);
        query.leaving = no_primitive;
        query.interval.from = world_.camera.near_along(query.ray.direction);
        query.interval.to = Real<T>::infinity;
        if (world_.max_distance) {
            query.interval.to = *world_.max_distance;
        }
    }

    /// Fills in where the primary ray that has hit something meets it.
    void find_surface(PrimaryAnswer<T>& answer) const {
        const Ray<T>& ray = answer.query->ray;
        answer.surface = surface_at(answer.hit, ray);
        answer.front = inner(ray.direction, answer.surface->geometric_normal) < 0;
        const UnitVec3<T>& n = answer.surface->shading_normal;
        answer.normal = answer.front ? n.vec() : -n.vec();
    }

    /// Whether a shadow ray is sent from a hit of this shape to a light that does this there.
    bool sends_shadow_ray(PrimitiveId shape, const Illumination<T>& at) const {
        return settings_.shadows != ShadowMode::none && at.in_front() && material_of(shape).lit;
    }

    /// The shadow ray that leaves a surface for a light.
    void shadow_query(const Vec3<T>& point, bool front, PrimitiveId shape,
                      const Illumination<T>& at, Query<T>& query) const {
        leave(point, at.towards, front, query.ray);
        query.leaving = shape;
        // What is as far as the light within rounding is where the light is, not in between.
        query.interval.from = 0;
        query.interval.to = at.distance * (1 - 8 * Real<T>::unit_roundoff);
    }

  private:
    using RayHandle = typename Recorder::RayHandle;
    using MediaList = std::conditional_t<facts.transmissive, Media, NoMedia>;

    Rgb<T> trace_pixel(int i, int j, const Query<T>& query, const PrimaryAnswer<T>* known) {
        rays_ = 0;
        finite_ = true;
        const Branch primary(query, known);
        const Rgb<T> intensity = trace(primary, RayHandle{}).intensity;
        if (!finite_ || !isfinite(intensity)) {
            throw InputError("", "pixel " + std::to_string(i) + "," + std::to_string(j),
                             "the intensities of its tree grow beyond the largest number of this "
                             "precision; lower kr, kt, or the intensity of the lights");
        }
        return intensity;
    }

    /// A ray about to be followed.
    struct Branch {
        Branch(const Query<T>& asked, const PrimaryAnswer<T>* answer)
            : query(asked),
              kind(RayKind::primary),
              level(1),
              weight(T(1)),
              path(0),
              known(answer) {}
        /// One more level after `before`; its query is yet to be written.
        Branch(const Branch& before, RayKind grown, const Rgb<T>& heavy, T way)
            : kind(grown),
              level(before.level + 1),
              weight(heavy),
              path(before.path + way),
              media(before.media) {}

        Query<T> query;
        RayKind kind;
        int level;
        Rgb<T> weight;
        T path;  ///< length from the eye to its start
        [[no_unique_address]] MediaList media;
        const PrimaryAnswer<T>* known = nullptr;  ///< where it has been asked already
    };
    struct Result {
        Rgb<T> intensity;
        T attenuation = 1;  ///< f of the distance to its hit
    };
    /// A hit with all that its illumination and its branches need.
    struct Node {
        Node(const Branch& from, RayHandle known_as, const Hit<T>& met, const SurfacePoint<T>& at,
             std::uint32_t of, const WorldMaterial<T>& made_of)
            : branch(from),
              handle(known_as),
              hit(met),
              surface(at),
              front(inner(from.query.ray.direction, at.geometric_normal) < 0),
              normal(front ? at.shading_normal.vec() : -at.shading_normal.vec()),
              material_id(of),
              material(made_of),
              kr(made_of.kr),
              kt(made_of.kt) {}

        const Branch& branch;
        RayHandle handle;
        Hit<T> hit;
        const SurfacePoint<T>& surface;
        bool front;
        Vec3<T> normal;  ///< n of the model
        std::uint32_t material_id;
        const WorldMaterial<T>& material;
        Snell<T> snell;
        Rgb<T> kr, kt;
        T attenuation = 1;
        RayEnd<T> end;
    };

    Result trace(const Branch& branch, RayHandle parent);
    Result miss(const Branch& branch, RayHandle handle);
    Result meet(const Branch& branch, RayHandle handle, const Hit<T>& hit);
    Result meet(const Branch& branch, RayHandle handle, const Hit<T>& hit,
                const SurfacePoint<T>& surface);
    /// A ray that leaves a hit to the outer or the inner side of its surface.
    static void leave(const Vec3<T>& point, const Vec3<T>& direction, bool outwards, Ray<T>& ray) {
        ray.origin = point;
        ray.direction = direction;
        ray.origin_error = 4 * Real<T>::unit_roundoff * largest_component(point);
        ray.going = outwards ? Going::outwards : Going::inwards;
    }
    // Flattened, as other functions are, so that it has the instruction set of the tracer.
    [[gnu::flatten]] SurfacePoint<T> surface_at(const Hit<T>& hit, const Ray<T>& ray) const {
        return world_.shapes.shapes().template surface_at<facts.shapes>(hit.primitive, ray, hit.t);
    }
    std::uint32_t material_id_of(PrimitiveId shape) const {
        return world_.material_of_object[world_.shapes.shapes()[shape].object];
    }
    const WorldMaterial<T>& material_of(PrimitiveId shape) const {
        return world_.materials[material_id_of(shape)];
    }
    [[gnu::flatten]] void refract(Node& node) const;
    void light(Node& node);
    void shine(Node& node, std::size_t light, const Illumination<T>& at);
    void send_in_vain(const Node& node, std::size_t light, const Illumination<T>& at);
    Rgb<T> transmitted(const Query<T>& query, std::size_t light, std::optional<Hit<T>>& blocker);
    [[gnu::flatten]] bool hidden(const Query<T>& query, std::size_t light);
    bool may_grow(const Node& node, RayKind kind, const Rgb<T>& weight, Reason& why_not) const;
    bool grow(Node& node, RayKind kind, Reason& why_not);

    const World<T>& world_;
    const Settings& settings_;
    Recorder& recorder_;
    std::vector<PrimitiveId> last_occluder_;  ///< by light, of the last ray to it; may be none
    std::size_t rays_ = 0;
    bool finite_ = true;
};

template <class T, class Recorder, Facts facts>
auto Tracer<T, Recorder, facts>::trace(const Branch& branch, RayHandle parent) -> Result {
    ++rays_;
    const RayHandle handle =
        recorder_.start(parent, {branch.kind, branch.level, branch.query.ray, branch.weight});
    if (branch.known) {
        const Hit<T>& hit = branch.known->hit;
        return hit.primitive != no_primitive ? meet(branch, handle, hit) : miss(branch, handle);
    }
    const auto hit = world_.shapes.closest(branch.query, recorder_.tests);
    return hit ? meet(branch, handle, *hit) : miss(branch, handle);
}

template <class T, class Recorder, Facts facts>
auto Tracer<T, Recorder, facts>::miss(const Branch& branch, RayHandle handle) -> Result {
    const bool primary = branch.kind == RayKind::primary;
    RayEnd<T> end;
    end.intensity = primary ? world_.background : world_.secondary_background;
    end.termination = world_.max_distance ? Reason::max_distance : Reason::no_intersection;
    recorder_.end(handle, end);
    return {end.intensity, T(1)};
}

template <class T, class Recorder, Facts facts>
auto Tracer<T, Recorder, facts>::meet(const Branch& branch, RayHandle handle, const Hit<T>& hit)
    -> Result {
    if (branch.known) {
        return meet(branch, handle, hit, *branch.known->surface);
    }
    return meet(branch, handle, hit, surface_at(hit, branch.query.ray));
}

template <class T, class Recorder, Facts facts>
auto Tracer<T, Recorder, facts>::meet(const Branch& branch, RayHandle handle, const Hit<T>& hit,
                                      const SurfacePoint<T>& surface) -> Result {
    const Vec3<T>& d = branch.query.ray.direction;
    const std::uint32_t material = material_id_of(hit.primitive);
    Node node(branch, handle, hit, surface, material, world_.materials[material]);
    if (facts.attenuated && branch.kind != RayKind::primary) {
        node.attenuation = world_.attenuation.at(hit.t);
    }
    if constexpr (facts.transmissive) {
        if (node.material.transmissive) {
            refract(node);
        }
    }
    recorder_.hit(handle, {hit, node.surface.point, node.normal, node.front, -inner(d, node.normal),
                           node.material.transmissive ? &node.snell : nullptr, node.kr, node.kt});

    node.end.attenuation = node.attenuation;
    node.end.ambient = node.material.ambient;
    light(node);
    node.end.intensity = node.end.ambient + node.end.diffuse + node.end.specular;
    Reason not_reflected{}, not_refracted{};
    const bool reflects = grow(node, RayKind::reflected, not_reflected);
    const bool refracts = grow(node, RayKind::refracted, not_refracted);
    if (!reflects && !refracts) {
        const Reason later = std::max(not_reflected, not_refracted);
        node.end.termination = later <= Reason::not_transmissive ? Reason::opaque : later;
    }
    recorder_.end(handle, node.end);
    return {node.end.intensity, node.attenuation};
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
                       node.branch.query.ray.direction, node.normal);
    if (node.snell.total_reflection() &&
        settings_.total_internal_reflection == TotalReflection::reflect) {
        node.kr += node.kt;
    }
}

template <class T, class Recorder, Facts facts> void Tracer<T, Recorder, facts>::light(Node& node) {
    if (!Recorder::wants_reasons && !node.material.lit && facts.spare_shadow_rays) {
        return;
    }
    const auto* const known = node.branch.known;
    for (std::size_t k = 0; k < world_.lights.size(); ++k) {
        const Illumination<T> at =
            known && !known->lights.empty()
                ? known->lights[k]
                : illuminate(world_.lights[k], node.surface.point, node.normal);
        if constexpr (!facts.spare_shadow_rays) {
            send_in_vain(node, k, at);
        }
        if (!at.in_front()) {
            recorder_.skip_light(node.handle, k, Reason::light_behind_surface);
        } else if (!node.material.lit) {
            recorder_.skip_light(node.handle, k, Reason::surface_unlit);
        } else {
            shine(node, k, at);
        }
    }
}

/// What is not to be done: sends the shadow ray that cannot change anything.
template <class T, class Recorder, Facts facts>
void Tracer<T, Recorder, facts>::send_in_vain(const Node& node, std::size_t light,
                                              const Illumination<T>& at) {
    if (!(at.in_front() && node.material.lit) && settings_.shadows == ShadowMode::opaque &&
        largest_component(at.towards) > 0) {
        Query<T> query;
        shadow_query(node.surface.point, node.front, node.hit.primitive, at, query);
        hidden(query, light);
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
        const auto* const known = node.branch.known;
        if (known && !known->hidden.empty()) {
            shadow.transmittance = Rgb<T>(known->hidden[light] != 0 ? T(0) : T(1));
        } else {
            Query<T> query;
            shadow_query(node.surface.point, node.front, node.hit.primitive, at, query);
            shadow.transmittance = transmitted(query, light, shadow.blocker);
        }
    }
    if (!is_zero(shadow.transmittance)) {
        shadow.adds =
            local_light(settings_.specular_model, node.material, world_.lights[light], at,
                        node.normal, node.branch.query.ray.direction, shadow.transmittance);
        node.end.diffuse += shadow.adds.diffuse;
        node.end.specular += shadow.adds.specular;
    }
    if (settings_.shadows != ShadowMode::none) {
        recorder_.shadow(node.handle, shadow);
    }
}

/// How much of a light comes through, and which surface stops it.
template <class T, class Recorder, Facts facts>
Rgb<T> Tracer<T, Recorder, facts>::transmitted(const Query<T>& query, std::size_t light,
                                               std::optional<Hit<T>>& blocker) {
    if (settings_.shadows == ShadowMode::opaque) {
        if constexpr (Recorder::wants_reasons) {
            blocker = world_.shapes.closest(query, recorder_.tests);
            return Rgb<T>(blocker ? T(0) : T(1));
        } else {
            return Rgb<T>(hidden(query, light) ? T(0) : T(1));
        }
    }
    Rgb<T> through(T(1));
    for (const Hit<T>& hit :
         world_.shapes.all(query.ray, query.leaving, query.interval, recorder_.tests)) {
        through *= material_of(hit.primitive).kt;
        if (is_zero(through)) {
            blocker = hit;
            break;
        }
    }
    return through;
}

/// Whether anything is in between. Where the last ray to the light was stopped, what stopped it is
/// asked first: neighbours are often in the same shadow.
template <class T, class Recorder, Facts facts>
bool Tracer<T, Recorder, facts>::hidden(const Query<T>& query, std::size_t light) {
    PrimitiveId& last = last_occluder_[light];
    if (facts.try_last_occluder && last != no_primitive) {
        recorder_.tests.add();
        if (world_.shapes.meets(last, query)) {
            return true;
        }
    }
    last = world_.shapes.occluder(query, recorder_.tests);
    return last != no_primitive;
}

/// Whether a branch is grown; else `why_not` is the first reason in the model's order.
template <class T, class Recorder, Facts facts>
bool Tracer<T, Recorder, facts>::may_grow(const Node& node, RayKind kind, const Rgb<T>& weight,
                                          Reason& why_not) const {
    const bool reflected = kind == RayKind::reflected;
    if (is_zero(reflected ? node.kr : node.kt)) {
        why_not = reflected ? Reason::not_reflective : Reason::not_transmissive;
    } else if (!reflected && node.snell.total_reflection()) {
        why_not = Reason::total_internal_reflection;
    } else if (node.branch.level >= settings_.max_depth) {
        why_not = Reason::max_depth;
    } else if (largest_component(weight) < world_.min_weight) {
        why_not = Reason::low_intensity;
    } else if (rays_ >= settings_.ray_budget) {
        why_not = Reason::ray_budget;
    } else {
        return true;
    }
    return false;
}

/// Follows a branch and adds its share to the hit's intensity; else false, and `why_not` says why.
template <class T, class Recorder, Facts facts>
bool Tracer<T, Recorder, facts>::grow(Node& node, RayKind kind, Reason& why_not) {
    const bool reflected = kind == RayKind::reflected;
    if (reflected ? !facts.reflective : !facts.transmissive) {
        why_not = reflected ? Reason::not_reflective : Reason::not_transmissive;
        recorder_.skip_branch(node.handle, kind, why_not);
        return false;
    }
    const Rgb<T>& k = reflected ? node.kr : node.kt;
    const Rgb<T> weight = node.attenuation * (k * node.branch.weight);
    finite_ = finite_ && isfinite(weight);
    if (!may_grow(node, kind, weight, why_not)) {
        recorder_.skip_branch(node.handle, kind, why_not);
        return false;
    }
    const Vec3<T>& d = node.branch.query.ray.direction;
    const UnitVec3<T> direction = reflected ? reflected_direction(d, node.normal)
                                            : refracted_direction(node.snell, d, node.normal);
    Branch next(node.branch, kind, weight, node.hit.t);
    leave(node.surface.point, direction.vec(), node.front == reflected, next.query.ray);
    next.query.leaving = node.hit.primitive;
    if (world_.max_distance) {
        next.query.interval.to = *world_.max_distance - next.path;
    }
    if constexpr (facts.transmissive) {
        if (!reflected && node.front) {
            next.media.enter(node.material_id);
        } else if (!reflected) {
            next.media.leave(node.material_id);
        }
    }
    const Result result = trace(next, node.handle);
    node.end.intensity += result.attenuation * (k * result.intensity);
    return true;
}

}  // namespace raytree
