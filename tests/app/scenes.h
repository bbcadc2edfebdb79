#pragma once

#include <memory>

#include "state/document.h"

/// Scenes that the inspector's tests are made of.
namespace raytree::inspector::test {

/// A glass ball over a floor, a mirror behind it, a point light and a directional one.
Scene glass_ball_scene();

std::shared_ptr<const Document> document_of(Scene scene);
Opened opened(Scene scene);

}  // namespace raytree::inspector::test
