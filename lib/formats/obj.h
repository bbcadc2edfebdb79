#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"

/// Wavefront OBJ: triangles of it, as a mesh.
namespace raytree {

/// Reads the faces of an OBJ file with their vertex normals. A face of more than three vertices is
/// fanned from its first; triangles without area are left out with a warning that counts them.
/// `file` names it in messages. Throws InputError (file and line) for numbers that are none, for
/// indices out of range, faces of fewer than three vertices, and where no triangle remains.
Mesh read_obj(std::string_view text, const std::filesystem::path& file,
              std::vector<std::string>& warnings);

/// `read_obj` of the file's text; Mesh::file is its name.
Mesh load_obj(const std::filesystem::path& file, std::vector<std::string>& warnings);

/// A whole scene around one mesh: one material, a key light, and a camera that looks at the mesh
/// from the front, the right and above, so that its bounding sphere fills most of the smaller side
/// of a picture of `width` times `height` pixels (each 1 or more).
Scene scene_around(Mesh mesh, const std::string& name, int width = 640, int height = 480);

}  // namespace raytree
