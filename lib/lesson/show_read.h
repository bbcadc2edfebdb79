#pragma once

#include <string>

#include "lesson/lesson.h"

/// Reading what a step shows.
namespace raytree::lesson {

/// What the next step begins with.
Show carried_over(const Show& before);

/// Reads the members of `value` over what `show` has already.
void read_show(const Json& value, const JsonPlace& place, JsonReport& report, Show& show);

Expression read_expression(const Json& value, const JsonPlace& place, JsonReport& report);

/// What is said of an id that the check catalogue does not have.
std::string unknown_mistake(const std::string& id);

}  // namespace raytree::lesson
