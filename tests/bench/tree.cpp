// One pixel's tree: from a scene that is loaded, its hierarchy built or not.

#include <cmath>

#include "support/generate.h"
#include "support/report.h"
#include "tree/record.h"

using namespace raytree;
using namespace raytree::bench;

namespace {

/// The scene with a mirror's surface, so that trees are deep.
Scene mirrored(const std::string& name, std::size_t shapes) {
    Scene scene = generate(name, shapes);
    scene.materials[0].kr = Colour(0.5);
    scene.settings.max_depth = 6;
    return scene;
}

void measure(const Options& options, Report& report, const std::string& name, std::size_t shapes) {
    const Scene scene = mirrored(name, shapes);
    const World<double> world(scene);
    const int center = scene.camera.width / 2;
    constexpr int repeats = 50;
    std::size_t rays = 0;
    const auto times =
        in_turn({{"tree",
                  [&] {
                      for (int k = 0; k < repeats; ++k) {
                          rays = record_tree(world, center + k % 7, center + k % 5).rays.size();
                      }
                  }},
                 {"build", [&] { const World<double> again(scene); }}},
                options.rounds);
    report.row({name,
                {static_cast<double>(world.shapes.shapes().size()), 0},
                {static_cast<double>(rays), 0},
                {times[0].median / repeats * 1e6, 1},
                {times[1].median * 1e3, 1}});
}

void body(const Options& options) {
    Report report(options, "One pixel's tree, depth 6, in double");
    report.table(
        "Processor time of one thread: the tree of a scene whose hierarchy is built, and "
        "the building.",
        {"scene", "shapes", "rays of the last", "tree, us", "prepare, ms"});
    std::vector<std::size_t> sizes = {1'000, 7'381, 100'000, 1'000'000, 10'000'000};
    sizes.resize(options.quick ? 2 : 5);
    if (options.shapes > 0) {
        sizes = {options.shapes};
    }
    for (const std::string& name : {std::string("balls"), std::string("terrain")}) {
        for (const std::size_t size : sizes) {
            if (options.scene.empty() || options.scene == name) {
                measure(options, report, name, size);
            }
        }
    }
    report.finish();
}

}  // namespace

int main(int argc, char** argv) {
    return bench::run("tree", "one pixel's tree from a loaded scene", argc, argv, body);
}
