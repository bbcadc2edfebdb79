// The lecture's hierarchies and the one that renders: what a ray is tested against, and its time.

#include <algorithm>
#include <cmath>

#include "accel/lecture_hierarchy.h"
#include "support/generate.h"
#include "support/report.h"

using namespace raytree;
using namespace raytree::bench;

namespace {

struct Kind {
    LectureKind kind;
    const char* name;
};
constexpr Kind kinds[] = {{LectureKind::brute_force, "brute force"},
                          {LectureKind::spheres, "bounding spheres"},
                          {LectureKind::boxes, "bounding boxes"},
                          {LectureKind::octree, "octree"}};

constexpr std::size_t rays_per_run = 4096;
constexpr std::size_t most_tests = 20'000'000;  ///< of brute force, a run

using Queries = std::vector<Query<double>>;

void measure(const Options& options, Report& report, const std::string& name, std::size_t size,
             std::vector<Report::Series>& curves) {
    const Scene scene = generate(name, size);
    const Intersector<double> production(scene);
    const ShapeSet<double>& shapes = production.shapes();
    const Queries rays = make_rays(scene, production, RayOrder::random, false, rays_per_run);
    std::vector<LectureIntersector> lecture;
    lecture.reserve(std::size(kinds));
    std::vector<Rival> rivals;
    std::vector<std::size_t> asked;
    for (const Kind& kind : kinds) {
        const LectureIntersector& hierarchy = lecture.emplace_back(kind.kind, shapes);
        const std::size_t few = std::max<std::size_t>(1, most_tests / (shapes.size() + 1));
        const std::size_t count =
            kind.kind == LectureKind::brute_force ? std::min(few, rays.size()) : rays.size();
        asked.push_back(count);
        rivals.push_back({kind.name, [&rays, &hierarchy, count] {
                              LectureCount tests;
                              for (std::size_t k = 0; k < count; ++k) {
                                  hierarchy.closest(rays[k].ray, no_primitive, {}, tests);
                              }
                          }});
    }
    NoTestCount none;
    asked.push_back(rays.size());
    rivals.push_back({"production", [&] {
                          for (const Query<double>& query : rays) {
                              production.closest(query.ray, no_primitive, {}, none);
                          }
                      }});
    const auto times = in_turn(rivals, options.rounds);
    for (std::size_t k = 0; k < rivals.size(); ++k) {
        LectureCount tests;
        TestCount production_tests;
        for (std::size_t ray = 0; ray < asked[k]; ++ray) {
            if (k < lecture.size()) {
                lecture[k].closest(rays[ray].ray, no_primitive, {}, tests);
            } else {
                production.closest(rays[ray].ray, no_primitive, {}, production_tests);
            }
        }
        const auto count = static_cast<double>(asked[k]);
        const double nanoseconds = times[k].median / count * 1e9;
        const bool lectured = k < lecture.size();
        report.row(
            {name,
             {static_cast<double>(shapes.size()), 0},
             rivals[k].name,
             {lectured ? static_cast<double>(tests.volumes) / count : NAN, 1},
             {static_cast<double>(lectured ? tests.shapes : production_tests.tests) / count, 1},
             {nanoseconds, 0},
             {(times[k].high - times[k].low) / times[k].median * 100, 0},
             {times[0].median / static_cast<double>(asked[0]) * 1e9 / nanoseconds, 1}});
        curves[k].name = rivals[k].name;
        curves[k].x.push_back(static_cast<double>(shapes.size()));
        curves[k].y.push_back(nanoseconds);
    }
}

void body(const Options& options) {
    Report report(options, "Hierarchies: the lecture's, and the one that renders");
    report.table(
        "Random rays, closest hit, one at a time, one thread. `volumes`: boxes, spheres or cells "
        "that a ray is tested against (the production hierarchy tests eight boxes at once and "
        "does not count them); `shapes`: shapes; `times`: as fast as brute force.",
        {"scene", "shapes", "hierarchy", "volumes", "shapes met", "ns a ray", "± %", "times"});
    std::vector<std::size_t> sizes = {100, 1'000, 10'000, 100'000};
    sizes.resize(options.quick ? 2 : 4);
    if (options.shapes > 0) {
        sizes = {options.shapes};
    }
    for (const std::string& name : {std::string("balls"), std::string("terrain")}) {
        if (!options.scene.empty() && options.scene != name) {
            continue;
        }
        std::vector<Report::Series> curves(std::size(kinds) + 1);
        for (const std::size_t size : sizes) {
            measure(options, report, name, size, curves);
        }
        report.plot(name, "Time of a random ray: " + name, "shapes", "nanoseconds", curves);
    }
    report.finish();
}

}  // namespace

int main(int argc, char** argv) {
    return bench::run("hierarchies", "brute force, spheres, boxes, octree, production", argc, argv,
                      body);
}
