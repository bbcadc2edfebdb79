#include "check/forge.h"

#include <doctest/doctest.h>

#include <filesystem>

#include "folders.h"
#include "formats/scene_file.h"
#include "formats/tree_json.h"
#include "tree/record.h"

namespace raytree::check {
namespace {

TEST_CASE("the steps of the model, one by one, grow the trees that the tracer grows") {
    std::size_t trees = 0;
    for (const auto& entry : std::filesystem::directory_iterator(RAYTREE_DATA_DIR "/scenes")) {
        if (entry.path().extension() != ".json") {
            continue;
        }
        const Scene scene = load_scene(entry.path()).scene;
        const World<double> world(scene);
        CAPTURE(entry.path().filename().string());
        for (int n = 0; n < 24; ++n) {
            const int i = (n * 7919 + 13) % scene.camera.width;
            const int j = (n * 104729 + 7) % scene.camera.height;
            CAPTURE(i);
            CAPTURE(j);
            RayTree<double> traced = record_tree(world, i, j);
            RayTree<double> forged = forge_tree(world, model_laws(), i, j);
            REQUIRE(forged.rays.size() == traced.rays.size());
            forged.generator = traced.generator;
            forged.counts = traced.counts;
            REQUIRE(write_tree_json(forged) == write_tree_json(traced));
            ++trees;
        }
    }
    CHECK(trees > 400);
}

}  // namespace
}  // namespace raytree::check
