// Whole pictures beside POV-Ray 3.7: the same scenes, size and depth.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <regex>

#include "formats/output_file.h"
#include "formats/scene_file.h"
#include "support/povray.h"
#include "support/process.h"
#include "support/report.h"
#include "support/standard.h"
#include "trace/render.h"

using namespace raytree;
using namespace raytree::bench;

namespace {

constexpr int threads = 2;

/// What POV-Ray says of its own tracing, without parsing and output; not numbers where it failed.
struct PovTime {
    double wall = NAN, processor = NAN;
};

PovTime povray(const std::string& file, const Camera& camera) {
    const ProcessRun run =
        run_process({"povray", "+I" + file, "+W" + std::to_string(camera.width),
                     "+H" + std::to_string(camera.height), "-A", "-D", "-F", "+WT2"});
    static const std::regex wall(R"(Trace Time:[^(]*\(([0-9.]+) seconds\))");
    static const std::regex processor(
        R"(Trace Time:[^\n]*\n[^\n]*with ([0-9.]+) CPU-seconds total)");
    std::smatch of_wall, of_processor;
    PovTime time;
    if (run.code == 0 && std::regex_search(run.said, of_wall, wall)) {
        time.wall = std::stod(of_wall[1]);
    }
    if (run.code == 0 && std::regex_search(run.said, of_processor, processor)) {
        time.processor = std::stod(of_processor[1]);
    }
    return time;
}

struct Medians {
    std::vector<double> process_wall, process, pov_wall, pov, one_wall, two_wall, one, two;
};

double least(const std::vector<double>& values) {
    return values.empty() ? NAN : *std::min_element(values.begin(), values.end());
}

double median_or_nothing(const std::vector<double>& values) {
    return values.empty() ? NAN : median_of(values);
}

/// The scene as an NFF file: that of others if it is there, else one made here.
std::string nff_file(const std::string& name, const Options& options,
                     const TemporaryFolder& folder) {
    const auto given = std::filesystem::path(options.data) / "nff" / (name + ".nff");
    if (std::filesystem::exists(given)) {
        return given.string();
    }
    save_scene(standard_scene(name, options.data), folder.file(name + ".nff"));
    return folder.file(name + ".nff");
}

/// Our whole process and POV-Ray's tracing in turn, then one thread and two.
Medians measure(const Options& options, const std::string& ours, const Scene& scene,
                const TemporaryFolder& folder) {
    const std::string size =
        std::to_string(scene.camera.width) + 'x' + std::to_string(scene.camera.height);
    const std::string theirs = folder.file("scene.pov");
    write_output(theirs, povray_text(scene));
    const bool has_povray = on_path("povray");
    const World<double> world(scene);
    Medians m;
    for (int round = -1; round < options.rounds; ++round) {
        const ProcessRun run = run_process({programs_folder() + "/raytree", "render", ours, "-o",
                                            folder.file("out.png"), "--size", size, "--threads",
                                            std::to_string(threads)});
        if (run.code != 0) {
            throw std::runtime_error("raytree render: " + run.said);
        }
        const PovTime pov = has_povray ? povray(theirs, scene.camera) : PovTime{};
        const auto time = [&](int count, std::vector<double>& wall, std::vector<double>& spent) {
            const double begin = wall_seconds(), used = process_seconds();
            render(world, {.threads = count, .progress = {}});
            if (round >= 0) {
                wall.push_back(wall_seconds() - begin);
                spent.push_back(process_seconds() - used);
            }
        };
        time(1, m.one_wall, m.one);
        time(threads, m.two_wall, m.two);
        if (round >= 0) {
            m.process_wall.push_back(run.wall);
            m.process.push_back(run.processor);
            if (std::isfinite(pov.wall)) {
                m.pov_wall.push_back(pov.wall);
                m.pov.push_back(pov.processor);
            }
        }
    }
    return m;
}

void body(const Options& options) {
    Report report(options, "Pictures: whole Whitted pictures, beside POV-Ray 3.7");
    report.table(
        "512 x 512 pixels, depth 5, no antialiasing, two threads, from an NFF file. `raytree`: the "
        "whole process, start, reading, building, tracing and writing; `POV-Ray`: its own report "
        "of tracing "
        "alone. In seconds waited (median; `least`: of the shortest of each), and of processor "
        "time. `2 / 1`: one thread's time over that of two, tracing alone, the shortest of each.",
        {"scene", "objects", "raytree", "POV-Ray", "times", "times, least", "raytree cpu",
         "POV-Ray cpu", "times, cpu", "trace 1", "trace 2", "2 / 1"});
    for (const std::string& name : standard_names()) {
        if (!options.scene.empty() && options.scene != name) {
            continue;
        }
        const TemporaryFolder folder;
        const std::string file = nff_file(name, options, folder);
        const int side = options.quick ? 128 : 512;
        SceneOptions sized;
        sized.size = {side, side};
        const Scene scene = load_scene(file, sized).scene;
        const Medians m = measure(options, file, scene, folder);
        const double ours = median_or_nothing(m.process_wall);
        const double theirs = median_or_nothing(m.pov_wall);
        report.row({name,
                    {static_cast<double>(scene.objects.size()), 0},
                    {ours, 3},
                    {theirs, 3},
                    {theirs / ours, 1},
                    {least(m.pov_wall) / least(m.process_wall), 1},
                    {median_or_nothing(m.process), 3},
                    {median_or_nothing(m.pov), 3},
                    {median_or_nothing(m.pov) / median_or_nothing(m.process), 1},
                    {least(m.one_wall), 3},
                    {least(m.two_wall), 3},
                    {least(m.one_wall) / least(m.two_wall), 2}});
    }
    if (!on_path("povray")) {
        report.note("POV-Ray (Debian: povray) is not there: raytree alone was measured.");
    }
    report.finish();
}

}  // namespace

int main(int argc, char** argv) {
    return bench::run("pictures", "whole pictures beside POV-Ray", argc, argv, body);
}
