// What accuracy costs: the error of pixels, hits and directions over the time that they take, for
// the three arithmetics, for shallower trees, and for other programs.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "accuracy/scene_files.h"
#include "accuracy/study.h"
#include "formats/scene_file.h"
#include "support/generate.h"
#include "support/report.h"

using namespace raytree;
using namespace raytree::bench;

namespace {

void draw(const std::string& json, const std::string& png) {
    const std::string command =
        "'" RAYTREE_PYTHON "' '" RAYTREE_ACCURACY_PLOT "' '" + json + "' '" + png + "'";
    if (std::system(command.c_str()) != 0) {
        throw std::runtime_error("no picture could be drawn of " + json +
                                 " (it takes Debian's python3-matplotlib)");
    }
}

void study(const Options& options, Report& report, Subject subject) {
    const std::string name = subject.name;
    Study study(options, std::move(subject));
    study.run();
    const auto point = [&](const std::string& label) -> WorkPoint {
        const auto found = std::ranges::find(study.points(), label, &WorkPoint::label);
        return found != study.points().end() ? *found : WorkPoint{};
    };
    const WorkPoint own = point("default"), in_float = point("float"), in_double = point("double");
    const WorkPoint embree = point("Embree"), povray = point("POV-Ray");
    const auto microseconds = [](const WorkPoint& p) {
        return Cell(p.seconds > 0 ? p.seconds * 1e6 : NAN, -3);
    };
    const auto error = [](const WorkPoint& p) { return Cell(p.intensity.rms(), -2); };
    report.row({name, microseconds(own), error(own), microseconds(in_double), error(in_double),
                microseconds(in_float), error(in_float), Cell(in_float.other_shape, 0),
                microseconds(embree), error(embree), Cell(embree.other_shape, 0),
                microseconds(povray), error(povray), own.on_front ? "yes" : "no"});
    report.note(name + ": " + study.verdict() + ".");
    if (!options.folder.empty()) {
        const std::string file = options.folder + "/accuracy-" + name;
        study.write(file + ".json");
        draw(file + ".json", file + ".png");
    }
}

void accuracy(const Options& options) {
    Report report(options, "Run time against error: what accuracy costs");
    report.table(
        "Time for a pixel in microseconds of one thread, and the root mean square error of its "
        "intensity against the reference arithmetic with trees of 13 or 16 levels; `shape`: pixels "
        "whose tree has another shape.",
        {"scene", "default", "error", "double", "error", "float", "error", "shape", "Embree",
         "error", "shape", "POV-Ray", "error", "default on front"});
    bool any = false;
    for (const auto& [name, file] : accuracy_scenes(options.data)) {
        if (!options.scene.empty() ? name == options.scene
                                   : !options.quick || name == "glass-ball") {
            study(options, report, {name, name, load_scene(file).scene});
            any = true;
        }
    }
    for (const std::string& name : generated_names()) {
        if (!options.scene.empty() ? name == options.scene : !options.quick) {
            const std::size_t shapes = options.shapes > 0 ? options.shapes : 1000;
            study(
                options, report,
                {name, name + " of " + std::to_string(shapes) + " shapes", generate(name, shapes)});
            any = true;
        }
    }
    if (!any) {
        throw std::invalid_argument("--scene: there is no scene \"" + options.scene + '"');
    }
    report.finish();
}

}  // namespace

int main(int argc, char** argv) {
    return run("accuracy", "error over run time, for arithmetics, settings and other programs",
               argc, argv, accuracy);
}
