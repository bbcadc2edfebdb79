#pragma once

#include <cstddef>
#include <optional>

#include "state/state.h"

/// Where commands go from the selected ray; none where there is no such ray.
namespace raytree::inspector {

using Target = std::optional<std::size_t> (*)(const State&);

/// In the order of computation, without hidden rays.
std::optional<std::size_t> next_ray(const State& state);
std::optional<std::size_t> previous_ray(const State& state);
std::optional<std::size_t> parent_ray(const State& state);
std::optional<std::size_t> child_ray(const State& state);
/// The next of the same hit.
std::optional<std::size_t> sibling_ray(const State& state);
std::optional<std::size_t> primary_ray(const State& state);

}  // namespace raytree::inspector
