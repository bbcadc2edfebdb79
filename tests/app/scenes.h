#pragma once

#include <memory>

#include "state/state.h"

/// Scenes that the inspector's tests are made of.
namespace raytree::inspector::test {

/// A glass ball over a floor, a mirror behind it, a point light and a directional one.
Scene glass_ball_scene();

std::shared_ptr<const Document> document_of(Scene scene);
Opened opened(Scene scene);

/// Runs a command and waits for the tree that it asks for.
void run_and_wait(State& state, std::string_view id, std::string_view argument = {});

}  // namespace raytree::inspector::test
