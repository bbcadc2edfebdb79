// Traces one pixel of a scene file and says what its primary ray hits.
#include <cstdio>

#include "check/check.h"
#include "formats/scene_file.h"
#include "tree/record.h"

int main(int argc, char** argv) {
    if (argc != 2) {
        return 2;
    }
    const raytree::LoadedScene loaded = raytree::load_scene(argv[1]);
    const raytree::World<double> world(loaded.scene);
    const raytree::RayTree<double> tree = raytree::record_tree(world, 320, 250);
    std::printf("%zu rays, the primary one hits %s\n", tree.rays.size(),
                tree.rays[0].hit ? "something" : "nothing");
    return 0;
}
