#pragma once

#include "check/check.h"

namespace raytree::check {

/// Whether there is enough to take what explains it for more than chance: a number, or several
/// decisions. One missing ray may be missing for many reasons.
bool tells_enough(const Report& report);

/// Whether there is enough to be sure of the one mistake of the catalogue that explains it: what is
/// wrong in itself, and does not only follow, has a number that a formula gave, or more decisions
/// than another mistake would take alike. What is hit, blocked, let through or sent is a decision;
/// so is a sign, and a ray reflected at a surface across one of the axes may differ in signs alone.
bool is_unmistakable(const Report& report);

}  // namespace raytree::check
