#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "formats/json_parse.h"
#include "formats/scene_file.h"
#include "trace/world.h"

namespace raytree::lesson {

/// A scene as a step shows it: what its file says, with the step's change.
struct StagedScene {
    std::filesystem::path file;
    LoadedScene loaded;
    Json document;  ///< the scene so changed, every default written out

    const Scene& scene() const { return loaded.scene; }
};

/// Reads the scene of `file` (in any format) and applies `change`: a JSON merge patch (RFC 7396) of
/// its raytree-scene/1.0 document in which lights and objects go by their names. Null changes
/// nothing. Throws InputError.
std::shared_ptr<const StagedScene> stage_scene(const std::filesystem::path& file,
                                               const Json& change);

/// A scene that has been read already.
std::shared_ptr<const StagedScene> as_it_is(const std::filesystem::path& file, LoadedScene loaded);

/// The scene with the member of its document that `pointer` (RFC 6901) names set to `value`.
std::shared_ptr<const StagedScene> change_scene(const StagedScene& scene,
                                                const std::string& pointer, const Json& value);

}  // namespace raytree::lesson
