#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace raytree::bench {

/// The scenes of lessons (named LESSON-SCENE), the examples, and the SPD's (named spd-SCENE) where
/// they are below `shared_data`; by name.
std::vector<std::pair<std::string, std::filesystem::path>> accuracy_scenes(
    const std::string& shared_data);

}  // namespace raytree::bench
