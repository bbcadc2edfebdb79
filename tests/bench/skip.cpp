// What each kind of skipping spares: the same pictures with it and without.

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <utility>

#include "folders.h"
#include "formats/scene_file.h"
#include "scene/input_error.h"
#include "scene/plan.h"
#include "support/generate.h"
#include "support/report.h"
#include "support/standard.h"
#include "trace/render.h"
#include "trace/tracer.h"

using namespace raytree;
using namespace raytree::bench;

namespace {

/// Counts rays and tests and nothing else.
struct Tally : NoRecorder<double> {
    TestCount tests;
    std::size_t rays = 0, lights_skipped = 0;

    RayHandle start(RayHandle, const RayStart<double>&) {
        ++rays;
        return nullptr;
    }
    void shadow(RayHandle, const ShadowEvent<double>&) { ++rays; }
    void skip_light(RayHandle, std::size_t, Reason) { ++lights_skipped; }
};

template <class Recorder, Facts facts>
void trace_all(const World<double>& world, Recorder& recorder, Picture& picture) {
    Tracer<double, Recorder, facts> tracer(world, recorder);
    for (int j = 0; j < picture.height; ++j) {
        for (int i = 0; i < picture.width; ++i) {
            picture.pixels[static_cast<std::size_t>(j * picture.width + i)] =
                tracer.trace_pixel(i, j);
        }
    }
}

/// A way to trace a picture, fast and with its rays and tests counted.
struct Way {
    void (*fast)(const World<double>&, Picture&) = nullptr;
    void (*tallied)(const World<double>&, Picture&, Tally&) = nullptr;
};

template <Facts facts> Way way() {
    return {[](const World<double>& world, Picture& picture) {
                NoRecorder<double> nothing;
                trace_all<NoRecorder<double>, facts>(world, nothing, picture);
            },
            [](const World<double>& world, Picture& picture, Tally& tally) {
                trace_all<Tally, facts>(world, tally, picture);
            }};
}

// A bit for each fact of a plan.
struct Fact {
    const char* name;
    bool Plan::*needed;
};
constexpr std::array<Fact, 5> plan_facts = {
    {{"reflection", &Plan::reflective},
     {"transmission and media", &Plan::transmissive},
     {"attenuation", &Plan::attenuated},
     {"transforms", &Plan::transforms},
     {"interpolated normals", &Plan::interpolated_normals}}};
constexpr unsigned all_facts = (1U << plan_facts.size()) - 1;

constexpr Facts facts_of(unsigned bits) {
    return {(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, {(bits & 8) != 0, (bits & 16) != 0}};
}

Way way_of(unsigned bits) {
    static const auto ways = []<std::size_t... k>(std::index_sequence<k...>) {
        return std::array{way<facts_of(k)>()...};
    }
    (std::make_index_sequence<all_facts + 1>());
    return ways[bits];
}

unsigned bits_of(const Plan& plan) {
    unsigned bits = 0;
    for (std::size_t k = 0; k < plan_facts.size(); ++k) {
        bits |= (plan.*plan_facts[k].needed ? 1U : 0U) << k;
    }
    return bits;
}

constexpr Facts without_last_occluder = [] {
    Facts facts;
    facts.try_last_occluder = false;
    return facts;
}();
constexpr Facts with_rays_in_vain = [] {
    Facts facts;
    facts.spare_shadow_rays = false;
    return facts;
}();

Way recorded() {
    return {[](const World<double>& world, Picture& picture) {
                CountingRecorder<double> recorder;
                trace_all<CountingRecorder<double>, Facts{}>(world, recorder, picture);
            },
            way_of(all_facts).tallied};
}

Way together() {
    return {[](const World<double>& world, Picture& picture) {
                picture = render(world, {.threads = 1, .progress = {}});
            },
            way_of(all_facts).tallied};
}

struct Pair {
    std::string what;
    Way with, without;  ///< the skipping
};

std::vector<Pair> pairs_of(const Plan& plan) {
    const unsigned needed = bits_of(plan);
    std::vector<Pair> pairs;
    for (std::size_t k = 0; k < plan_facts.size(); ++k) {
        if ((needed >> k & 1) == 0) {
            pairs.push_back({std::string("plan: no ") + plan_facts[k].name, way_of(needed),
                             way_of(needed | 1U << k)});
        }
    }
    if (needed != all_facts) {
        pairs.push_back({"plan: all of it", way_of(needed), way_of(all_facts)});
    }
    if (plan.shadow_rays) {
        pairs.push_back({"shadow rays in vain", way_of(all_facts), way<with_rays_in_vain>()});
        pairs.push_back({"last occluder first", way_of(all_facts), way<without_last_occluder>()});
    }
    pairs.push_back({"recording", way_of(all_facts), recorded()});
    pairs.push_back({"rays one by one", together(), way_of(needed)});
    return pairs;
}

double difference(const Picture& a, const Picture& b) {
    double largest = 0;
    for (std::size_t k = 0; k < a.pixels.size(); ++k) {
        const Rgb<double>&p = a.pixels[k], &q = b.pixels[k];
        largest =
            std::max({largest, std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)});
    }
    return largest;
}

Picture picture_of(const Scene& scene) {
    return {scene.camera.width, scene.camera.height,
            std::vector<Rgb<double>>(static_cast<std::size_t>(scene.camera.width) *
                                     static_cast<std::size_t>(scene.camera.height))};
}

std::size_t rays_of(const Tally& tally, const std::string& what, bool with) {
    return tally.rays + (what == "shadow rays in vain" && !with ? tally.lights_skipped : 0);
}

void add_row(Report& report, const std::string& scene_name, const std::string& what,
             const std::array<Tally, 2>& tallies, const std::vector<Timing>& times, double differ) {
    report.row({scene_name,
                what,
                {static_cast<double>(rays_of(tallies[0], what, true)), 0},
                {static_cast<double>(rays_of(tallies[1], what, false)), 0},
                {static_cast<double>(tallies[0].tests.tests), 0},
                {static_cast<double>(tallies[1].tests.tests), 0},
                {times[0].median * 1e3, 1},
                {times[1].median * 1e3, 1},
                {speedup(times[0], times[1]), 2},
                differ == 0 ? "the same" : "differs by " + Cell(differ, -2).shown()});
}

void measure_ways(const Options& options, Report& report, const Scene& scene) {
    const World<double> world(scene);
    for (const Pair& pair : pairs_of(plan_of(scene))) {
        Picture with = picture_of(scene), without = with;
        std::array<Tally, 2> tallies;
        pair.with.tallied(world, with, tallies[0]);
        pair.without.tallied(world, without, tallies[1]);
        const auto times = in_turn({{"with", [&] { pair.with.fast(world, with); }},
                                    {"without", [&] { pair.without.fast(world, without); }}},
                                   options.rounds);
        add_row(report, scene.name, pair.what, tallies, times, difference(with, without));
    }
}

/// Branches that weigh less than the scene asks for.
void measure_weight(const Options& options, Report& report, const Scene& scene) {
    Scene all = scene;
    all.settings.min_weight = 0;
    const World<double> world(scene), without(all);
    const Way way = way_of(bits_of(plan_of(scene)));
    Picture a = picture_of(scene), b = a;
    std::array<Tally, 2> tallies;
    way.tallied(world, a, tallies[0]);
    way.tallied(without, b, tallies[1]);
    const auto times =
        in_turn({{"with", [&] { way.fast(world, a); }}, {"without", [&] { way.fast(without, b); }}},
                options.rounds);
    add_row(report, scene.name, "weight below min_weight", tallies, times, difference(a, b));
}

/// Small enough to be traced many times.
void shrink(Camera& camera, int widest) {
    const double share = std::min(1.0, static_cast<double>(widest) / camera.width);
    camera.width = std::max(1, static_cast<int>(std::lround(camera.width * share)));
    camera.height = std::max(1, static_cast<int>(std::lround(camera.height * share)));
}

std::vector<Scene> all_scenes(const Options& options) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(RAYTREE_LESSONS_DIR)) {
        if (entry.path().extension() == ".json" && entry.path().filename() != "lesson.json") {
            files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    std::vector<Scene> scenes;
    for (const std::filesystem::path& file : files) {
        Scene scene = load_scene(file).scene;
        scene.name = file.parent_path().filename().string() + '/' + file.stem().string();
        scenes.push_back(std::move(scene));
    }
    for (const std::string& name : standard_names()) {
        scenes.push_back(standard_scene(name, options.data));
        scenes.back().name = name;
    }
    for (const std::string& name : {std::string("terrain"), std::string("atrium")}) {
        scenes.push_back(generate(name, options.quick ? 1'000 : 100'000));
    }
    return scenes;
}

void body(const Options& options) {
    Report report(options, "Skipping: what it spares, and that the picture is the same");
    report.table(
        "One thread, pixel by pixel unless rays go together. `with` the skipping, and `without`: "
        "rays, tests of a ray with a shape, milliseconds. `times`: without over with.",
        {"scene", "skipped", "rays with", "rays without", "tests with", "tests without", "ms with",
         "ms without", "times", "picture"});
    for (Scene& scene : all_scenes(options)) {
        if (!options.scene.empty() && scene.name.find(options.scene) == std::string::npos) {
            continue;
        }
        shrink(scene.camera, options.quick ? 32 : 128);
        measure_ways(options, report, scene);
        if (scene.settings.min_weight > 0 && plan_of(scene).branches()) {
            measure_weight(options, report, scene);
        }
    }
    report.finish();
}

}  // namespace

int main(int argc, char** argv) {
    return bench::run("skip", "what each kind of skipping spares", argc, argv, body);
}
