// One pixel's tree: from a scene that is loaded, its hierarchy built or not, and from a file.

#include <algorithm>
#include <cmath>

#include "support/generate.h"
#include "support/process.h"
#include "support/report.h"
#include "support/scene_files.h"
#include "support/standard.h"
#include "tree/record.h"

using namespace raytree;
using namespace raytree::bench;

namespace {

constexpr int depth = 6;

/// The scene with a mirror's surface, so that trees are deep.
Scene mirrored(const std::string& name, std::size_t shapes) {
    Scene scene = generate(name, shapes);
    scene.materials[0].kr = Colour(0.5);
    scene.settings.max_depth = depth;
    return scene;
}

struct Pixel {
    int i, j;
};

/// Pixels over the whole picture; the one in the middle first.
std::vector<Pixel> pixels_of(const Camera& camera) {
    std::vector<Pixel> pixels = {{camera.width / 2, camera.height / 2}};
    for (int j = 1; j < 8; ++j) {
        for (int i = 1; i < 8; ++i) {
            pixels.push_back({camera.width * i / 8, camera.height * j / 8});
        }
    }
    return pixels;
}

void measure(const Options& options, Report& report, const std::string& name, const Scene& scene) {
    const World<double> world(scene);
    const std::vector<Pixel> pixels = pixels_of(scene.camera);
    std::size_t rays = 0, most = 0;
    for (const Pixel& pixel : pixels) {
        const std::size_t of_pixel = record_tree(world, pixel.i, pixel.j).rays.size();
        rays += of_pixel;
        most = std::max(most, of_pixel);
    }
    double slowest = 0;
    const auto all = [&] {
        for (const Pixel& pixel : pixels) {
            const double begin = thread_seconds();
            record_tree(world, pixel.i, pixel.j);
            slowest = std::max(slowest, thread_seconds() - begin);
        }
    };
    const auto first = [&](Build build) {
        const World<double> anew(scene, build);
        record_tree(anew, pixels[0].i, pixels[0].j);
    };
    const auto trees = in_turn({{"trees", all}}, options.rounds);
    const auto builds = in_turn(
        {{"first", [&] { first(Build::where_rays_go); }}, {"whole", [&] { first(Build::whole); }}},
        options.rounds, process_seconds);
    const auto count = static_cast<double>(pixels.size());
    report.row({name,
                {static_cast<double>(world.shapes.shapes().size()), 0},
                {static_cast<double>(rays) / count, 1},
                {static_cast<double>(most), 0},
                {trees[0].median / count * 1e6, 1},
                {slowest * 1e6, 1},
                {builds[0].median * 1e3, 2},
                {builds[1].median * 1e3, 2},
                {speedup(builds[0], builds[1]), 1}});
}

void measure_file(const Options& options, Report& report, const std::string& name,
                  const Scene& scene) {
    const TemporaryFolder folder;
    const std::string file = write_scene_files(scene, folder);
    const Pixel middle = pixels_of(scene.camera)[0];
    std::vector<double> wall, processor;
    for (int round = -1; round < options.rounds; ++round) {
        const ProcessRun run =
            run_process({programs_folder() + "/raytree", "trace", file, "--pixel",
                         std::to_string(middle.i) + ',' + std::to_string(middle.j), "-o",
                         folder.file("tree.json")});
        if (run.code != 0) {
            throw std::runtime_error("raytree trace: " + run.said);
        }
        if (round >= 0) {
            wall.push_back(run.wall);
            processor.push_back(run.processor);
        }
    }
    report.row({name,
                {static_cast<double>(shape_count(scene)), 0},
                {median_of(wall) * 1e3, 1},
                {median_of(processor) * 1e3, 1}});
}

struct Subject {
    std::string name;
    Scene scene;
};

template <class Visit> void for_each_subject(const Options& options, Visit&& visit) {
    if (options.shapes == 0 && (options.scene.empty() || options.scene == "standard")) {
        Scene scene = standard_scene("balls", options.data);
        scene.settings.max_depth = depth;
        visit("balls of the SPD", scene);
    }
    std::vector<std::size_t> sizes = {1'000, 10'000, 100'000, 1'000'000, 10'000'000};
    sizes.resize(options.quick ? 2 : 5);
    if (options.shapes > 0) {
        sizes = {options.shapes};
    }
    for (const std::string& name : {std::string("terrain"), std::string("atrium")}) {
        for (const std::size_t size : sizes) {
            if (options.scene.empty() || options.scene == name) {
                visit(name, mirrored(name, size));
            }
        }
    }
}

void body(const Options& options) {
    Report report(options, "One pixel's tree, depth 6, in double");
    report.table(
        "From a loaded scene, processor time. `tree`: the mean of 50 pixels, hierarchy built; "
        "`slowest`: the longest of them ever. `first`: the first tree of a scene just loaded, "
        "built where its rays go; `whole`: the same after building the whole.",
        {"scene", "shapes", "rays", "most rays", "tree, us", "slowest, us", "first, ms",
         "whole, ms", "times"});
    for_each_subject(options, [&](const std::string& name, const Scene& scene) {
        measure(options, report, name, scene);
    });
    report.table("From a file: `raytree trace` from its start to its end, milliseconds.",
                 {"scene", "shapes", "waited", "processor"});
    for_each_subject(options, [&](const std::string& name, const Scene& scene) {
        measure_file(options, report, name, scene);
    });
    report.finish();
}

}  // namespace

int main(int argc, char** argv) {
    return bench::run("tree", "one pixel's tree from a loaded scene and from a file", argc, argv,
                      body);
}
