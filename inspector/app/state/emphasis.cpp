#include "state/emphasis.h"

namespace raytree::inspector {
namespace {

/// The selected ray with its ancestors and children; under the primary ray every ray.
std::vector<bool> not_of_the_ray(const PixelTree& tree, std::size_t selected) {
    std::vector<bool> aside(tree.tree.rays.size(), selected != 0);
    for (const std::size_t child : tree.children[selected]) {
        aside[child] = false;
    }
    for (auto at = std::optional(selected); at; at = parent_of(tree, *at)) {
        aside[*at] = false;
    }
    return aside;
}

}  // namespace

std::vector<bool> set_aside(const State& state) {
    const PixelTree& tree = *state.tree();
    const RayFilter& filter = state.look().filter;
    std::vector<bool> aside;
    if (state.thing()) {
        aside.assign(tree.tree.rays.size(), true);
        for (const std::size_t ray :
             rays_that_concern(state.document()->scene(), tree.tree, *state.thing())) {
            aside[ray] = false;
        }
    } else {
        aside = not_of_the_ray(tree, state.selected()->id);
    }
    for (const TreeRay<double>& ray : tree.tree.rays) {
        if (!filter.empty() && shown(filter, tree, ray) != Shown::full) {
            aside[ray.id] = true;
        }
    }
    return aside;
}

Emphasis emphasis_of(const State& state) {
    const PixelTree& tree = *state.tree();
    const RayFilter& filter = state.look().filter;
    Emphasis emphasis;
    if (!filter.empty()) {
        for (const TreeRay<double>& ray : tree.tree.rays) {
            emphasis.faded.push_back(shown(filter, tree, ray) != Shown::full);
        }
    }
    if (state.thing()) {
        emphasis.marked.resize(tree.tree.rays.size());
        for (const std::size_t ray :
             rays_that_concern(state.document()->scene(), tree.tree, *state.thing())) {
            emphasis.marked[ray] = true;
        }
    }
    return emphasis;
}

}  // namespace raytree::inspector
