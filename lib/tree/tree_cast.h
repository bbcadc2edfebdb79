#pragma once

#include <optional>

#include "tree/ray_tree.h"

namespace raytree {

namespace detail {

template <class To, class From> TreeHit<To> hit_cast(const TreeHit<From>& from) {
    TreeHit<To> to;
    to.object = from.object;
    to.material = from.material;
    to.t = static_cast<To>(from.t);
    to.point = vector_cast<To>(from.point);
    to.normal = vector_cast<To>(from.normal);
    to.side = from.side;
    to.cos_incident = static_cast<To>(from.cos_incident);
    if (from.interface) {
        to.interface = {static_cast<To>(from.interface->eta1),
                        static_cast<To>(from.interface->eta2),
                        static_cast<To>(from.interface->sin2_transmitted)};
    }
    to.kr = rgb_cast<To>(from.kr);
    to.kt = rgb_cast<To>(from.kt);
    return to;
}

template <class To, class From> ShadowPart<To> shadow_cast(const ShadowPart<From>& from) {
    ShadowPart<To> to;
    to.light = from.light;
    if (from.distance) {
        to.distance = static_cast<To>(*from.distance);
    }
    if (from.blocked_by) {
        to.blocked_by = {from.blocked_by->object, static_cast<To>(from.blocked_by->t)};
    }
    to.transmittance = rgb_cast<To>(from.transmittance);
    return to;
}

template <class To, class From> TreeRay<To> ray_cast(const TreeRay<From>& from) {
    TreeRay<To> to;
    to.id = from.id;
    to.parent = from.parent;
    to.kind = from.kind;
    to.level = from.level;
    to.origin = vector_cast<To>(from.origin);
    to.direction = vector_cast<To>(from.direction);
    to.weight = rgb_cast<To>(from.weight);
    to.attenuation = static_cast<To>(from.attenuation);
    if (from.hit) {
        to.hit = hit_cast<To>(*from.hit);
    }
    to.ambient = rgb_cast<To>(from.ambient);
    to.diffuse = rgb_cast<To>(from.diffuse);
    to.specular = rgb_cast<To>(from.specular);
    to.intensity = rgb_cast<To>(from.intensity);
    to.termination = from.termination;
    to.skipped = from.skipped;
    if (from.shadow) {
        to.shadow = shadow_cast<To>(*from.shadow);
    }
    return to;
}

}  // namespace detail

/// The same tree with every number rounded to `To`.
template <class To, class From> RayTree<To> tree_cast(const RayTree<From>& from) {
    RayTree<To> to;
    to.generator = from.generator;
    to.scene_name = from.scene_name;
    to.scene_sha256 = from.scene_sha256;
    to.pixel_i = from.pixel_i;
    to.pixel_j = from.pixel_j;
    to.camera = from.camera;
    to.settings = from.settings;
    to.intensity = rgb_cast<To>(from.intensity);
    to.counts = from.counts;
    to.rays.reserve(from.rays.size());
    for (const TreeRay<From>& ray : from.rays) {
        to.rays.push_back(detail::ray_cast<To>(ray));
    }
    return to;
}

}  // namespace raytree
