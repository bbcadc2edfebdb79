#pragma once

#include "state/state.h"

namespace raytree::inspector {

/// Gives the ray table the columns that it had when the program was last used, and keeps them for
/// the next time from now on. For a program that a user sits at: tests and scripts begin anew.
void remember_table(State& state);

}  // namespace raytree::inspector
