#pragma once

class QWidget;

namespace raytree::inspector {

/// Shows every command with its key.
void show_cheat_sheet(QWidget* parent);

}  // namespace raytree::inspector
