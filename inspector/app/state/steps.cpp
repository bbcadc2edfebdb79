#include "state/steps.h"

namespace raytree::inspector {
namespace {

bool is_shown(const State& state, std::size_t ray) {
    const PixelTree& tree = *state.tree();
    return shown(state.look().filter, tree, tree.tree.rays[ray]) != Shown::hidden;
}

/// The next ray in the order of computation that is not hidden, or the one before.
std::optional<std::size_t> step_target(const State& state, int by) {
    if (!state.tree()) {
        return std::nullopt;
    }
    const auto count = static_cast<std::ptrdiff_t>(state.tree()->tree.rays.size());
    auto ray = static_cast<std::ptrdiff_t>(state.selected()->id) + by;
    while (ray >= 0 && ray < count && !is_shown(state, static_cast<std::size_t>(ray))) {
        ray += by;
    }
    return ray >= 0 && ray < count ? std::optional(static_cast<std::size_t>(ray)) : std::nullopt;
}

}  // namespace

std::optional<std::size_t> next_ray(const State& state) { return step_target(state, 1); }
std::optional<std::size_t> previous_ray(const State& state) { return step_target(state, -1); }
std::optional<std::size_t> parent_ray(const State& state) {
    return state.tree() ? parent_of(*state.tree(), state.selected()->id) : std::nullopt;
}
std::optional<std::size_t> child_ray(const State& state) {
    return state.tree() ? first_child_of(*state.tree(), state.selected()->id) : std::nullopt;
}
std::optional<std::size_t> sibling_ray(const State& state) {
    return state.tree() ? sibling_of(*state.tree(), state.selected()->id, 1) : std::nullopt;
}
std::optional<std::size_t> primary_ray(const State& state) {
    return state.tree() ? std::optional<std::size_t>(0) : std::nullopt;
}

}  // namespace raytree::inspector
