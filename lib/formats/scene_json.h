#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "formats/json_reader.h"
#include "formats/json_text.h"
#include "scene/scene.h"

/// The format raytree-scene/1.0.
namespace raytree {

/// Reads a scene and validates it. `file` names it in messages and is where mesh files are looked
/// for beside. Throws InputError with every mistake found; warnings are added to `warnings`, one
/// sentence each, "file: place: text".
Scene read_scene_json(const std::string& text, const std::filesystem::path& file,
                      std::vector<std::string>& warnings);

/// The whole scene, such that reading it gives the same scene. A mesh is written by its file's
/// name.
std::string write_scene_json(const Scene& scene);

/// Parts of the format that ray trees share: each writes one value (an object) into `json`.
void write_scene_json(JsonWriter& json, const Scene& scene);
void write_camera_json(JsonWriter& json, const Camera& camera);
/// Every setting, defaults too.
void write_settings_json(JsonWriter& json, const Settings& settings);

/// Parts of the format that ray trees share: each reads one value, `place` in its document, reports
/// what is wrong in its shape, and leaves the ranges to `validate`.
Camera read_camera_json(const Json& value, const JsonPlace& place, JsonReport& report);
Settings read_settings_json(const Json& value, const JsonPlace& place, JsonReport& report);
/// The member `attenuation`, where there is one.
void read_attenuation_json(const ObjectReader& reader, Attenuation& out);
/// A whole scene, `document`; the meshes' files are looked for in `folder`.
Scene read_scene_json(const Json& document, const std::filesystem::path& folder,
                      JsonReport& report);

}  // namespace raytree
