#pragma once

#include <string>
#include <vector>

#include "check/report.h"

/// Pieces of reports that are JSON, without a line feed at their end.
namespace raytree::check {

std::string json_of(const Printed& of);
std::string json_of(const std::vector<Group>& groups);
/// A test of Gradescope's results.json; `output` is what the student reads.
std::string gradescope_of(const Printed& of, const std::string& output);

}  // namespace raytree::check
