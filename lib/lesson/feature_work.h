#pragma once

#include "lesson/features.h"

/// The features that take more than a few lines, each as data.
namespace raytree::lesson {

/// Throws ExpressionError: the step shows no `feature`, which `member` would say.
[[noreturn]] void not_shown(const char* feature, const char* member);

// features_hierarchy.cpp
Json traversal_json(const StageWorld& world, const Show& show, std::size_t ray);
Json hierarchies_json(const StageWorld& world, const Show& show, std::size_t ray);

// features_light.cpp
Json shower_json(const StageWorld& world, const Show& show, std::size_t ray);
Json volumes_json(const StageWorld& world, const Show& show, std::size_t ray);
Json depth_json(const StageWorld& world, const Show& show, std::size_t ray);

}  // namespace raytree::lesson
