#pragma once

#include <functional>

#include "state/commands.h"

class QWidget;

namespace raytree::inspector {

/// Shows every command with its key and what it does, to be searched and run: by Return or a double
/// click. Commands that are for scripts alone are listed as such, and those that are not possible
/// just now are greyed.
void show_cheat_sheet(const State& state, QWidget* parent, std::function<void(const Command&)> run);

}  // namespace raytree::inspector
