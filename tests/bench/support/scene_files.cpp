#include "support/scene_files.h"

#include <cstdio>

#include "formats/output_file.h"
#include "formats/scene_file.h"

namespace raytree::bench {

std::string write_scene_files(Scene scene, const TemporaryFolder& folder) {
    for (Object& object : scene.objects) {
        auto* const mesh = std::get_if<Mesh>(&object.shape);
        if (!mesh) {
            continue;
        }
        std::string text;
        char line[96];
        for (const Point& v : mesh->vertices) {
            std::snprintf(line, sizeof line, "v %.9g %.9g %.9g\n", v.x, v.y, v.z);
            text += line;
        }
        for (const Mesh::Triangle& t : mesh->triangles) {
            std::snprintf(line, sizeof line, "f %d %d %d\n", t[0].vertex + 1, t[1].vertex + 1,
                          t[2].vertex + 1);
            text += line;
        }
        write_output(folder.file("mesh.obj"), text);
        mesh->file = "mesh.obj";
    }
    save_scene(scene, folder.file("scene.json"));
    return folder.file("scene.json");
}

}  // namespace raytree::bench
