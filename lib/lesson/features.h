#pragma once

#include <span>
#include <string_view>

#include "accel/lecture_hierarchy.h"
#include "lesson/stage.h"
#include "trace/ray_list.h"
#include "trace/time_share.h"
#include "trace/work_precision.h"

/// What the library's features give, as data: for the expressions of lessons, and for everybody
/// through `raytree study`.
namespace raytree::lesson {

/// The names that `feature_member` knows.
std::span<const std::string_view> feature_names();

/// `picture`, `shower`, `traversal`, `hierarchies`, `volumes`, `depth`, `z_buffer`, `crossings`,
/// `time`, `accuracy`, `self_hits` and `lecture`; nothing for another name. A feature that needs to
/// know more takes it from `show`, and throws ExpressionError where it is not said there. `ray` is
/// the one that a feature about one ray is about.
std::optional<Value> feature_member(const StageWorld& world, const Show& show, std::size_t ray,
                                    std::string_view name);

/// Throws ExpressionError where a step shows a feature of what is not in the scene.
void check_features(const StageWorld& world, const Show& show, std::size_t ray);

/// A ray of a pixel's tree as the tracer followed it, with the shape that it left.
ListedRay<double> ray_of_tree(const StageWorld& world, Pixel pixel, std::size_t ray);

/// Measured once for each scene on the stage: what a text says of it is what a panel shows.
TimeShare time_share_of(const StageWorld& world);
WorkPrecision work_precision_of(const StageWorld& world);

/// The place of a light by its name. Throws ExpressionError.
std::size_t light_named(const Scene& scene, const std::string& name);

LectureKind lecture_kind(HierarchyKind kind);

}  // namespace raytree::lesson
