#pragma once

#include <span>
#include <string_view>

#include "lesson/stage.h"

/// What the library's features give, as data for expressions.
namespace raytree::lesson {

/// The names that `feature_member` knows.
std::span<const std::string_view> feature_names();

/// `picture`, `lecture`, and what the features that a step shows give; nothing for another name.
/// `ray` is the one that a feature about one ray is about.
std::optional<Value> feature_member(const StageWorld& world, const Show& show, std::size_t ray,
                                    std::string_view name);

/// Throws ExpressionError where a step shows a feature of what is not in the scene.
void check_features(const StageWorld& world, const Show& show, std::size_t ray);

}  // namespace raytree::lesson
