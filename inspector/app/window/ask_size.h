#pragma once

#include <string>

class QWidget;

namespace raytree::inspector {

/// Asks for the size of an image: "1920x1080", empty to do nothing.
std::string ask_size(QWidget* parent);

}  // namespace raytree::inspector
