#pragma once

#include <string>
#include <vector>

#include "tree/ray_tree.h"

namespace raytree::bench {

/// A ray of a pixel's tree, as far as trees of different programs are compared.
template <class T> struct Step {
    Step(RayKind of_kind, int at_level, const Vec3<T>& along)
        : kind(of_kind), level(at_level), direction(along) {}

    RayKind kind;
    int level;
    Vec3<T> direction;
    bool met = false;
    std::string object;  ///< what it met
    T t{};
    Vec3<T> point{};
    int lit_by = 0;  ///< lights of which something arrives there
};

/// Depth first: a ray, what was reflected, what was refracted.
template <class T> struct Steps {
    std::vector<Step<T>> rays;
    Rgb<T> intensity;
};

template <class T> Steps<T> steps_of(const RayTree<T>& tree) {
    Steps<T> steps;
    std::vector<std::size_t> place(tree.rays.size());
    for (const TreeRay<T>& ray : tree.rays) {
        if (ray.shadow) {
            steps.rays[place[*ray.parent]].lit_by += is_zero(ray.shadow->transmittance) ? 0 : 1;
            continue;
        }
        place[ray.id] = steps.rays.size();
        Step<T> step(ray.kind, ray.level, ray.direction);
        if (ray.hit) {
            step.met = true;
            step.object = ray.hit->object;
            step.t = ray.hit->t;
            step.point = ray.hit->point;
        }
        steps.rays.push_back(step);
    }
    steps.intensity = tree.intensity;
    return steps;
}

template <class A, class B> bool same_shape(const Step<A>& a, const Step<B>& b) {
    return a.kind == b.kind && a.level == b.level && a.met == b.met && a.object == b.object &&
           a.lit_by == b.lit_by;
}

}  // namespace raytree::bench
