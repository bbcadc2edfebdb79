// Time per ray, building time and memory as a scene grows tenfold and tenfold again.

#include <cmath>
#include <memory>

#include "support/embree.h"
#include "support/generate.h"
#include "support/report.h"

using namespace raytree;
using namespace raytree::bench;

namespace {

constexpr std::size_t rays_per_run = 1 << 16;

struct Curve {
    Report::Series time, memory;
};

void measure(const Options& options, Report& report, const std::string& name, std::size_t size,
             Curve& curve) {
    const Scene scene = generate(name, size);
    const double begin = process_seconds(), wall = wall_seconds();
    const Intersector<double> ours(scene);
    const double build = process_seconds() - begin, waited = wall_seconds() - wall;
    const auto coherent = make_rays(scene, ours, RayOrder::coherent, false, rays_per_run);
    const auto random = make_rays(scene, ours, RayOrder::random, false, rays_per_run);
    std::vector<Hit<double>> hits(rays_per_run);
    const auto times = in_turn(
        {{"coherent",
          [&] {
              ours.closest(coherent, std::span(hits).first(coherent.size()), Together::coherent);
          }},
         {"random",
          [&] {
              ours.closest(random, std::span(hits).first(random.size()), Together::any_order);
          }}},
        options.rounds);
    const auto on_all =
        in_turn({{"coherent",
                  [&] {
                      in_parts(coherent.size(), [&](std::size_t first, std::size_t count) {
                          ours.closest(std::span(coherent).subspan(first, count),
                                       std::span(hits).subspan(first, count), Together::coherent);
                      });
                  }}},
                options.rounds, wall_seconds);
    const auto shapes = static_cast<double>(ours.shapes().size());
    const double per_coherent = times[0].median / static_cast<double>(coherent.size()) * 1e9;
    const double bytes = static_cast<double>(ours.bytes()) / shapes;
    double embree_build = NAN, embree_bytes = NAN;
    if (EmbreeScene::available()) {
        const EmbreeScene embree(scene, EmbreeMode::robust);
        embree_build = embree.build_seconds() * 1e3;
        embree_bytes = embree.bytes() / shapes;
    }
    report.row({name,
                {shapes, 0},
                {per_coherent, 1},
                {times[1].median / static_cast<double>(random.size()) * 1e9, 1},
                {on_all[0].median / static_cast<double>(coherent.size()) * 1e9, 1},
                {build * 1e3, 1},
                {waited * 1e3, 1},
                {bytes, 1},
                {embree_build, 1},
                {embree_bytes, 1}});
    curve.time.x.push_back(shapes);
    curve.time.y.push_back(per_coherent);
    curve.memory.x.push_back(shapes);
    curve.memory.y.push_back(bytes);
}

void body(const Options& options) {
    Report report(options, "Growth: the same scene, ten times as many shapes");
    report.table(
        "Closest hits, one thread, handed over together; `all cores`: coherent ones, by the "
        "clock. Build: processor time of all "
        "threads, and the time waited for; Embree's on one thread, high quality, ROBUST.",
        {"scene", "shapes", "coherent, ns", "random, ns", "all cores, ns", "build, ms",
         "waited, ms", "bytes/shape", "Embree build, ms", "Embree bytes/shape"});
    std::vector<std::size_t> sizes = {100, 1'000, 10'000, 100'000, 1'000'000, 10'000'000};
    sizes.resize(options.quick ? 3 : 6);
    if (options.shapes > 0) {
        sizes = {options.shapes};
    }
    std::vector<Report::Series> times, memory;
    for (const std::string& name : generated_names()) {
        Curve curve{{name, {}, {}}, {name, {}, {}}};
        for (const std::size_t size : sizes) {
            if (options.scene.empty() || options.scene == name) {
                measure(options, report, name, size, curve);
            }
        }
        times.push_back(curve.time);
        memory.push_back(curve.memory);
    }
    report.plot("time", "Time of a coherent ray", "shapes", "nanoseconds", times);
    report.plot("memory", "Memory for hierarchy and shapes", "shapes", "bytes a shape", memory);
    report.finish();
}

}  // namespace

int main(int argc, char** argv) {
    return bench::run("growth", "time per ray, build and memory as a scene grows", argc, argv,
                      body);
}
