#pragma once

#include <string>

#include "scene/scene.h"
#include "support/process.h"

namespace raytree::bench {

/// Writes a scene of at most one mesh as files, as a user has them: scene.json, and the mesh as OBJ
/// beside it. The scene's file name.
std::string write_scene_files(Scene scene, const TemporaryFolder& folder);

}  // namespace raytree::bench
