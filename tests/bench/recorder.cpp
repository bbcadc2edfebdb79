// What a recorder costs: none in the source, one that is off, those that count and that record.

#include <cmath>

#include "bare_tracer.h"
#include "support/report.h"
#include "support/standard.h"
#include "trace/counting.h"
#include "trace/tracer.h"
#include "tree/record.h"

using namespace raytree;
using namespace raytree::bench;

namespace {

template <class Tracer, class Recorder> Rgb<double> trace_all(const World<double>& world) {
    Recorder recorder;
    Tracer tracer(world, recorder);
    const Camera& camera = world.scene().camera;
    Rgb<double> sum;
    for (int j = 0; j < camera.height; ++j) {
        for (int i = 0; i < camera.width; ++i) {
            sum += tracer.trace_pixel(i, j);
        }
    }
    return sum;
}

void measure(const Options& options, Report& report, const std::string& name) {
    using Off = NoRecorder<double>;
    using Counting = CountingRecorder<double>;
    Scene scene = standard_scene(name, options.data);
    scene.camera.width = scene.camera.height = options.quick ? 64 : 192;
    const World<double> world(scene);
    Rgb<double> without, off, counting, recorded;
    const auto times = in_turn(
        {{"without", [&] { without = trace_all<bare::Tracer<double, Off>, Off>(world); }},
         {"off", [&] { off = trace_all<Tracer<double, Off>, Off>(world); }},
         {"counting", [&] { counting = trace_all<Tracer<double, Counting>, Counting>(world); }},
         {"recording",
          [&] {
              recorded = {};
              for (int j = 0; j < scene.camera.height; ++j) {
                  for (int i = 0; i < scene.camera.width; ++i) {
                      recorded += record_tree(world, i, j).intensity;
                  }
              }
          }}},
        options.rounds);
    const bool same = without == off && off == counting && counting == recorded;
    report.row({name,
                {times[0].median * 1e3, 1},
                {times[1].median * 1e3, 1},
                {speedup(times[0], times[1]), 3},
                {(times[1].high - times[1].low) / times[1].median * 100, 1},
                {speedup(times[0], times[2]), 2},
                {speedup(times[0], times[3]), 2},
                same ? "the same" : "differs"});
}

void body(const Options& options) {
    Report report(options, "Recording: what it costs where nobody asks for it, and where one does");
    report.table(
        "Pictures pixel by pixel, one thread. `without`: the tracer's source with every call of a "
        "recorder taken out; `off`: compiled in and empty; then what counting rays, and recording "
        "each pixel's tree, take. Milliseconds, and times over `without`.",
        {"scene", "without, ms", "off, ms", "off", "± %", "counting", "recording", "picture"});
    for (const std::string& name : standard_names()) {
        if (options.scene.empty() || options.scene == name) {
            measure(options, report, name);
        }
    }
    report.finish();
}

}  // namespace

int main(int argc, char** argv) {
    return bench::run("recorder", "what a recorder costs, off and on", argc, argv, body);
}
