#pragma once

#include <string>
#include <vector>

#include "check/finding.h"
#include "check/rulebook.h"

/// What concerns a submission as a whole: whether it is of this scene, and whether it gives what is
/// required of it.
namespace raytree::check {

Finding of_the_whole(std::string subject, std::string reason);

/// False where there is nothing to compare with: its pixel is none of the scene's.
bool fits_scene(const Submission& submission, const Scene& scene, const Names& names,
                std::vector<Finding>& findings);

/// What no quantity shows: levels and counts that are not those of the rays, and materials that are
/// not those of the objects. Of a tree that is right in all else: what is wrong there explains
/// them.
void look_for_contradictions(const Submission& submission, const Rulebook& book,
                             std::vector<Finding>& findings);

/// What is required and missing is a finding, what else is missing a remark.
void look_for_missing_fields(const Submission& submission, const Given& required,
                             std::vector<Finding>& findings, std::vector<std::string>& remarks);

}  // namespace raytree::check
