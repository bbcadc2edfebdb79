#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "state/state.h"

/// Scenes that the inspector's tests are made of.
namespace raytree::inspector::test {

/// A glass ball over a floor, a mirror behind it, a point light and a directional one.
Scene glass_ball_scene();

/// A ball of glass in a room of mirrors: in pixel 3,2 of its 9 x 9 a tree that takes longer than a
/// glance.
Scene deep_scene();

/// A path in the folder for temporary files, of this process alone: two clones may run their tests
/// at the same time.
std::filesystem::path own_path(const std::string& name);

std::shared_ptr<const Document> document_of(Scene scene);
Opened opened(Scene scene);

/// Runs a command and waits for the tree that it asks for.
void run_and_wait(State& state, std::string_view id, std::string_view argument = {});

}  // namespace raytree::inspector::test
