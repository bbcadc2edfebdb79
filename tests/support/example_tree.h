#pragma once

#include "tree/ray_tree.h"

namespace raytree::test {

/// A ray tree of five rays whose numbers can be checked by hand:
///
///     #0 primary    hits ball, 36.87° from the normal
///     #1   shadow     reaches key; none to sun, which is behind the surface
///     #2   reflected  meets nothing
///     #3   refracted  hits ball from inside, where it is totally reflected
///     #4     shadow     to key, blocked by wall; none to sun
inline RayTree<double> example_tree() {
    RayTree<double> tree;
    tree.generator = "a test";
    tree.scene_name = "example";
    tree.scene_sha256 = std::string(64, 'a');
    tree.pixel_i = 3;
    tree.pixel_j = 4;
    tree.camera = {{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, HorizontalFov{60}, 0, 8, 6};
    tree.settings.max_depth = 3;
    tree.settings.min_weight = 0.1;
    tree.settings.attenuation = {1, 0.5, 0};
    tree.intensity = {0.425, 0.325, 0.375};
    tree.counts = {1, 1, 1, 2, 2, 2, 21, 12};

    TreeRay<double> eye;
    eye.origin = {0, 0, 5};
    eye.direction = {0, 0, -1};
    eye.hit =
        TreeHit<double>{"ball", "glass", 4, {0, 0, 1}, {0.6, 0, 0.8}, Side::front, 0.8, {}, {}, {}};
    eye.hit->interface = Interface<double>{1, 1.5, 0.16};
    eye.hit->kr = Rgb<double>(0.25);
    eye.hit->kt = Rgb<double>(0.5);
    eye.ambient = Rgb<double>(0.1);
    eye.diffuse = {0.2, 0.1, 0.05};
    eye.intensity = tree.intensity;
    eye.skipped = {{RayKind::shadow, "sun", Reason::light_behind_surface}};

    TreeRay<double> lit;
    lit.id = 1;
    lit.parent = 0;
    lit.kind = RayKind::shadow;
    lit.origin = {0, 0, 1};
    lit.direction = {0, 1, 0};
    lit.diffuse = eye.diffuse;
    lit.shadow = ShadowPart<double>{"key", 7.0, {}, Rgb<double>(1)};

    TreeRay<double> mirrored;
    mirrored.id = 2;
    mirrored.parent = 0;
    mirrored.kind = RayKind::reflected;
    mirrored.level = 2;
    mirrored.origin = {0, 0, 1};
    mirrored.direction = {0.96, 0, 0.28};
    mirrored.weight = Rgb<double>(0.25);
    mirrored.intensity = {0.4, 0.4, 0.8};
    mirrored.termination = Reason::no_intersection;

    TreeRay<double> inside;
    inside.id = 3;
    inside.parent = 0;
    inside.kind = RayKind::refracted;
    inside.level = 2;
    inside.origin = {0, 0, 1};
    inside.direction = {0, 0, -1};
    inside.weight = Rgb<double>(0.5);
    inside.attenuation = 0.5;
    inside.hit =
        TreeHit<double>{"ball", "glass", 2, {0, 0, -1}, {0, 0.8, 0.6}, Side::back, 0.6, {}, {}, {}};
    inside.hit->interface = Interface<double>{1.5, 1, 1.44};
    inside.hit->kr = Rgb<double>(0.25);
    inside.hit->kt = Rgb<double>(0.5);
    inside.ambient = inside.intensity = Rgb<double>(0.1);
    inside.termination = Reason::low_intensity;
    inside.skipped = {{RayKind::shadow, "sun", Reason::light_behind_surface},
                      {RayKind::reflected, "", Reason::low_intensity},
                      {RayKind::refracted, "", Reason::total_internal_reflection}};

    TreeRay<double> blocked;
    blocked.id = 4;
    blocked.parent = 3;
    blocked.kind = RayKind::shadow;
    blocked.level = 2;
    blocked.origin = {0, 0, -1};
    blocked.direction = {0, 1, 0};
    blocked.shadow = ShadowPart<double>{"key", 9.0, Blocker<double>{"wall", 3}, Rgb<double>(0)};

    tree.rays = {eye, lit, mirrored, inside, blocked};
    return tree;
}

}  // namespace raytree::test
