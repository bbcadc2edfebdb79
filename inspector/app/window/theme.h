#pragma once

#include "state/palette.h"

namespace raytree::inspector {

/// Gives all widgets of the program the colours of a theme.
void apply_theme(const Palette& palette);

}  // namespace raytree::inspector
