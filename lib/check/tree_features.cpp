#include "check/tree_features.h"

#include <algorithm>

namespace raytree::check {
namespace {

std::string object_of(const TreeHit<double>& hit) {
    return hit.object.substr(0, hit.object.find('#'));
}

void of_shadow(const TreeRay<double>& ray, const RayTree<double>& tree,
               std::set<std::string>& features) {
    const auto& hit = tree.rays[*ray.parent].hit;
    const std::string from = hit ? object_of(*hit) : "something";
    const Rgb<double>& passes = ray.shadow->transmittance;
    if (ray.shadow->blocked_by) {
        features.insert("a shadow ray from " + from + " to " + ray.shadow->light + " is blocked");
        features.insert("a shadow ray is blocked");
        features.insert("a shadow ray meets something");
    } else {
        if (std::min({passes.r, passes.g, passes.b}) < 1) {
            features.insert("a shadow ray from " + from + " to " + ray.shadow->light +
                            " goes through something");
            features.insert("a shadow ray goes through something");
            features.insert("a shadow ray meets something");
        }
        features.insert(from + " is lit by " + ray.shadow->light);
    }
    const bool highlight = std::max({ray.specular.r, ray.specular.g, ray.specular.b}) > 1e-3;
    if (highlight) {
        features.insert("there is a highlight");
    }
}

void of_skipped(const TreeRay<double>& ray, std::set<std::string>& features) {
    for (const Skipped& skipped : ray.skipped) {
        if (skipped.reason == Reason::light_behind_surface && ray.hit) {
            features.insert("the light " + skipped.light + " is behind the surface of " +
                            object_of(*ray.hit));
        } else if (skipped.reason == Reason::total_internal_reflection) {
            features.insert("a ray is totally reflected");
        } else if (skipped.reason == Reason::max_depth || skipped.reason == Reason::low_intensity) {
            features.insert("the tree is ended by " + std::string(word_of(skipped.reason)));
        }
    }
}

void of_ray(const TreeRay<double>& ray, const RayTree<double>& tree,
            std::set<std::string>& features) {
    const std::string kind = "a " + std::string(word_of(ray.kind)) + " ray";
    const bool primary = ray.kind == RayKind::primary;
    if (!ray.hit) {
        features.insert(primary ? "the primary ray hits nothing" : kind + " hits nothing");
        if (!primary) {
            features.insert("a secondary ray hits nothing");
        }
        return;
    }
    const std::string object = object_of(*ray.hit);
    features.insert((primary ? "the primary ray hits " : kind + " hits ") + object);
    if (ray.hit->side == Side::back) {
        features.insert("the inside of " + object + " is hit");
    }
    if (!primary) {
        features.insert("there is " + kind);
    }
    if (ray.kind == RayKind::refracted && ray.parent) {
        const auto& from = tree.rays[*ray.parent].hit;
        if (from) {
            features.insert("a refracted ray " +
                            std::string(from->side == Side::front ? "enters " : "leaves ") +
                            object_of(*from));
        }
    }
}

}  // namespace

std::set<std::string> features_of(const RayTree<double>& tree) {
    std::set<std::string> features;
    for (const TreeRay<double>& ray : tree.rays) {
        if (ray.shadow) {
            of_shadow(ray, tree, features);
            continue;
        }
        of_ray(ray, tree, features);
        of_skipped(ray, features);
        if (ray.level > 2) {
            features.insert("the tree has " + std::to_string(ray.level) + " levels or more");
        }
        if (std::max({ray.intensity.r, ray.intensity.g, ray.intensity.b}) > 1) {
            features.insert("an intensity is above 1");
        }
    }
    return features;
}

}  // namespace raytree::check
