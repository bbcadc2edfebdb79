#pragma once

#include <cstddef>
#include <string>

#include "formats/scene_file.h"
#include "scene/plan.h"

/// What `raytree info` says of a scene.
namespace raytree::cli {

struct SceneReport {
    std::string file;
    const LoadedScene& loaded;
    Plan plan;
    std::size_t hierarchy_nodes = 0;
    std::size_t hierarchy_bytes = 0;
};

std::string report_text(const SceneReport& report);
std::string report_json(const SceneReport& report);

}  // namespace raytree::cli
