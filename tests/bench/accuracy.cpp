// What accuracy costs: the error of pixels, hits and directions over the time that they take, for
// the three arithmetics, for shallower trees, and for other programs.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>

#include "formats/json_text.h"
#include "formats/output_file.h"
#include "formats/scene_file.h"
#include "support/embree_tracer.h"
#include "support/generate.h"
#include "support/povray.h"
#include "support/report.h"
#include "tree/record.h"

using namespace raytree;
using namespace raytree::bench;

namespace {

/// The truth: the reference arithmetic, deeper than anything that is held against it, with no
/// branch too light.
constexpr int deepest_truth = 16;
constexpr int shallowest_truth = 13;
/// How much longer the reference takes than double, roughly: by it the picture's size is chosen.
constexpr double reference_factor = 400;

/// Worst and root mean square of errors.
struct Errors {
    double worst = 0;
    double squares = 0;
    double count = 0;

    void add(double error) {
        worst = std::max(worst, error);
        squares += error * error;
        ++count;
    }
    double rms() const { return count > 0 ? std::sqrt(squares / count) : NAN; }
};

/// One way to make the picture: what it takes and how far it is off.
struct WorkPoint {
    std::string family, label;
    double seconds = 0, low = 0, high = 0;  ///< for each pixel
    Errors intensity{};                     ///< over pixels and channels
    double other_shape = NAN;               ///< pixels whose tree has another shape
    bool on_front = false;
};

/// What rounding alone does, at the truth's settings.
struct Rounding {
    std::string name;
    Errors distance;                ///< of a hit, relative
    Errors place;                   ///< of a hit point, as a share of the scene's size
    std::vector<Errors> direction;  ///< by the number of bounces
    Errors intensity;
    std::size_t other_shape = 0;
};

struct Subject {
    std::string name, title;
    Scene scene;
};

using Truth = std::vector<Steps<Quad>>;

Scene with(const Scene& scene, int max_depth, double min_weight) {
    Scene result = scene;
    result.settings.max_depth = max_depth;
    result.settings.min_weight = min_weight;
    return result;
}

template <class Visit> void for_each_pixel(const Scene& scene, Visit&& visit) {
    for (int j = 0; j < scene.camera.height; ++j) {
        for (int i = 0; i < scene.camera.width; ++i) {
            visit(i, j);
        }
    }
}

template <class T> std::vector<Steps<T>> all_steps(const World<T>& world) {
    std::vector<Steps<T>> result;
    for_each_pixel(world.scene(),
                   [&](int i, int j) { result.push_back(steps_of(record_tree(world, i, j))); });
    return result;
}

double off(double own, Quad exact) { return static_cast<double>(abs(Quad(own) - exact)); }

template <class T> double off(const Vec3<T>& own, const Vec3<Quad>& exact) {
    return static_cast<double>(length<Quad>(vector_cast<Quad>(own) - exact));
}

void add(Errors& errors, const Rgb<double>& own, const Rgb<Quad>& exact, double largest) {
    if (exact.r <= Quad(largest) && exact.g <= Quad(largest) && exact.b <= Quad(largest)) {
        errors.add(off(own.r, exact.r));
        errors.add(off(own.g, exact.g));
        errors.add(off(own.b, exact.b));
    }
}

Errors picture_errors(const Picture& picture, const Truth& truth, double largest) {
    Errors errors;
    for (std::size_t k = 0; k < truth.size(); ++k) {
        add(errors, picture.pixels[k], truth[k].intensity, largest);
    }
    return errors;
}

template <class T> bool same_shape(const Steps<T>& own, const Steps<Quad>& exact) {
    return std::ranges::equal(own.rays, exact.rays,
                              [](const auto& a, const auto& b) { return same_shape(a, b); });
}

template <class T> std::size_t other_shapes(const std::vector<Steps<T>>& own, const Truth& truth) {
    std::size_t count = 0;
    for (std::size_t k = 0; k < truth.size(); ++k) {
        count += same_shape(own[k], truth[k]) ? 0 : 1;
    }
    return count;
}

template <class T> Rounding rounding_of(const std::string& name, const std::vector<Steps<T>>& own,
                                        const Truth& truth, double size) {
    Rounding result{name, {}, {}, {}, {}, other_shapes(own, truth)};
    for (std::size_t p = 0; p < truth.size(); ++p) {
        add(result.intensity, rgb_cast<double>(own[p].intensity), truth[p].intensity, INFINITY);
        // Rays are compared as far as both trees go the same way.
        for (std::size_t k = 0; k < std::min(own[p].rays.size(), truth[p].rays.size()); ++k) {
            const Step<T>& a = own[p].rays[k];
            const Step<Quad>& b = truth[p].rays[k];
            if (a.kind != b.kind || a.level != b.level || a.object != b.object) {
                break;
            }
            const auto bounces = static_cast<std::size_t>(b.level - 1);
            result.direction.resize(std::max(result.direction.size(), bounces + 1));
            result.direction[bounces].add(off(a.direction, b.direction));
            if (b.met) {
                result.distance.add(off(static_cast<double>(a.t), b.t) / static_cast<double>(b.t));
                result.place.add(off(a.point, b.point) / size);
            }
        }
    }
    return result;
}

double size_of(const World<double>& world) {
    Box box;
    for (std::size_t k = 0; k < world.shapes.shapes().size(); ++k) {
        box.include(world.shapes.shapes().bounds(static_cast<PrimitiveId>(k)));
    }
    return length(box.size());
}

/// Marks what is both slower and worse than something else; times within 5 % count as the same.
void mark_front(std::vector<WorkPoint>& points) {
    for (WorkPoint& p : points) {
        p.on_front = std::ranges::none_of(points, [&](const WorkPoint& q) {
            const double error = q.intensity.rms(), own = p.intensity.rms();
            return (q.seconds < 0.95 * p.seconds && error <= own * (1 + 1e-9)) ||
                   (q.seconds < 1.05 * p.seconds && error < 0.95 * own);
        });
    }
}

/// "3.8", "250"
std::string times_text(double ratio) {
    const double unit = ratio < 10 ? 0.1 : std::pow(10, std::floor(std::log10(ratio)) - 1);
    return Cell(std::round(ratio / unit) * unit, ratio < 10 ? 1 : 0).shown();
}

class Study {
  public:
    Study(const Options& options, Subject subject)
        : options_(options), subject_(std::move(subject)) {}

    void run() {
        choose_size();
        const Scene deepest = with(subject_.scene, truth_depth_, 0);
        trace_truth(deepest);
        measure_settings(deepest);
        run_povray_too(deepest);
        find_rounding(deepest);
        mark_front(points_);
        judge_default();
    }

    const std::vector<WorkPoint>& points() const { return points_; }
    const std::vector<Rounding>& roundings() const { return roundings_; }
    const std::string& verdict() const { return verdict_; }
    const Scene& scene() const { return subject_.scene; }
    int truth_depth() const { return truth_depth_; }

    void write(const std::string& file) const;

  private:
    /// As many pixels and levels as the reference can do in some seconds.
    void choose_size() {
        const double budget = options_.quick ? 1 : 12;
        constexpr std::array<std::pair<int, int>, 5> sizes = {
            {{64, 40}, {48, 30}, {32, 20}, {24, 15}, {16, 10}}};
        Camera& camera = subject_.scene.camera;
        for (const int depth : {deepest_truth, shallowest_truth}) {
            truth_depth_ = depth;
            camera.width = sizes.back().first;
            camera.height = sizes.back().second;
            const Scene deepest = with(subject_.scene, depth, 0);
            const World<double> world(deepest);
            const double begin = thread_seconds();
            render(world, {1, {}});
            const double a_pixel = (thread_seconds() - begin) / (camera.width * camera.height);
            for (const auto& [width, height] : sizes) {
                if (a_pixel * width * height * reference_factor <= budget) {
                    camera.width = width;
                    camera.height = height;
                    return;
                }
            }
        }
    }

    double pixels() const {
        return static_cast<double>(subject_.scene.camera.width) * subject_.scene.camera.height;
    }

    /// Once: it takes hundreds of times as long as the rest.
    void trace_truth(const Scene& deepest) {
        const World<Quad> world(deepest);
        truth_ = all_steps(world);
        const double begin = thread_seconds();
        render(world, {1, {}});
        const double seconds = (thread_seconds() - begin) / pixels();
        WorkPoint point{"arithmetic", "reference", seconds, seconds, seconds, {}, 0};
        point.intensity.count = 1;
        points_.push_back(point);
    }

    struct Contender {
        WorkPoint point;
        std::unique_ptr<Scene> scene;
        std::function<Picture()> render;
    };

    template <class T> void enter(std::vector<Contender>& all, const std::string& family,
                                  const std::string& label, Scene scene) const {
        Contender contender{{family, label}, std::make_unique<Scene>(std::move(scene)), {}};
        auto world = std::make_shared<World<T>>(*contender.scene);
        contender.point.other_shape = static_cast<double>(other_shapes(all_steps(*world), truth_));
        contender.render = [world] { return render(*world, {1, {}}); };
        all.push_back(std::move(contender));
    }

    void measure_settings(const Scene& deepest) {
        std::vector<Contender> all;
        enter<float>(all, "arithmetic", "float", deepest);
        enter<double>(all, "arithmetic", "double", deepest);
        for (int depth = 1; depth <= 12; ++depth) {
            enter<double>(all, "max_depth", std::to_string(depth), with(deepest, depth, 0));
        }
        for (int exponent = 1; exponent <= 6; ++exponent) {
            enter<double>(all, "min_weight", "1e-" + std::to_string(exponent),
                          with(deepest, truth_depth_, std::pow(10, -exponent)));
        }
        const Settings defaults;
        enter<double>(all, "default", "default",
                      with(deepest, defaults.max_depth, defaults.min_weight));
        embree_why_not_ = EmbreeTracer::why_not(deepest);
        if (embree_why_not_.empty()) {
            const auto tracer = std::make_shared<EmbreeTracer>(deepest);
            Contender embree{{"embree", "Embree"}, nullptr, [tracer] { return tracer->render(); }};
            for_each_pixel(deepest,
                           [&](int i, int j) { embree_steps_.push_back(tracer->steps(i, j)); });
            embree.point.other_shape = static_cast<double>(other_shapes(embree_steps_, truth_));
            all.push_back(std::move(embree));
        }
        std::vector<Rival> rivals;
        for (Contender& each : all) {
            each.point.intensity = picture_errors(each.render(), truth_, INFINITY);
            rivals.push_back({each.point.label, [&each] { each.render(); }});
        }
        const auto times = in_turn(rivals, options_.rounds);
        for (std::size_t k = 0; k < all.size(); ++k) {
            WorkPoint& point = all[k].point;
            point.seconds = times[k].median / pixels();
            point.low = times[k].low / pixels();
            point.high = times[k].high / pixels();
            points_.push_back(point);
        }
    }

    void run_povray_too(const Scene& deepest) {
        povray_why_not_ = povray_why_not(deepest);
        if (!povray_why_not_.empty()) {
            return;
        }
        const PovrayRun run = run_povray(deepest);
        const double seconds = run.seconds_a_pixel;
        points_.push_back({"povray", "POV-Ray", seconds, seconds, seconds,
                           picture_errors(run.picture, truth_, 1)});
    }

    void find_rounding(const Scene& deepest) {
        const World<double> in_double(deepest);
        const World<float> in_float(deepest);
        const double size = size_of(in_double);
        roundings_.push_back(rounding_of("float", all_steps(in_float), truth_, size));
        if (!embree_steps_.empty()) {
            roundings_.push_back(rounding_of("Embree", embree_steps_, truth_, size));
        }
        roundings_.push_back(rounding_of("double", all_steps(in_double), truth_, size));
    }

    /// Says of the default settings that they are on the front, or what is better and why.
    void judge_default() {
        const auto own = std::ranges::find(points_, "default", &WorkPoint::family);
        const std::string name = "the default settings (6 levels, smallest weight 0.001, double)";
        if (own->on_front) {
            verdict_ = name + " are on the front";
            return;
        }
        const WorkPoint* better = nullptr;  // the most exact of those that take no longer
        for (const WorkPoint& p : points_) {
            if (&p != &*own && p.seconds < 1.05 * own->seconds &&
                p.intensity.rms() <= own->intensity.rms() * (1 + 1e-9) &&
                (!better || p.intensity.rms() < better->intensity.rms())) {
                better = &p;
            }
        }
        const double share = 100 * better->seconds / own->seconds;
        const double ratio = own->intensity.rms() / better->intensity.rms();
        const std::string what = better->family == "max_depth"
                                     ? better->label + " levels with any weight"
                                 : better->family == "min_weight"
                                     ? "a smallest weight of " + better->label + " with any depth"
                                     : better->label;
        const std::string why =
            better->family == "max_depth"
                ? "the trees of this scene end sooner; the default is for those that do not"
            : better->family == "min_weight"
                ? "in this scene light gets weak soon; the default also bounds the trees of "
                  "scenes where it does not"
                : "where cut trees are the larger error rounding does not matter; the default is "
                  "for those who look at numbers";
        verdict_ = name + " are not on the front: " + what + " takes " +
                   std::to_string(static_cast<int>(std::round(share))) + " % of the time with " +
                   (ratio > 1.05 ? "an error " + times_text(ratio) + " times smaller"
                                 : std::string("the same error")) +
                   "; " + why;
    }

    const Options& options_;
    Subject subject_;
    int truth_depth_ = deepest_truth;
    Truth truth_;
    std::vector<WorkPoint> points_;
    std::vector<Rounding> roundings_;
    std::vector<Steps<float>> embree_steps_;
    std::string embree_why_not_, povray_why_not_, verdict_;
};

void put(JsonWriter& json, const char* key, const Errors& errors) {
    json.key(key).begin_object();
    json.member("worst", errors.worst);
    json.key("rms");
    if (errors.count > 0) {
        json.value(errors.rms());
    } else {
        json.null();
    }
    json.end_object();
}

void Study::write(const std::string& file) const {
    using Layout = JsonWriter::Layout;
    JsonWriter json;
    json.begin_object(Layout::block);
    json.member("format", "raytree-accuracy/1.0").member("scene", subject_.title);
    json.member("machine", machine_text()).member("rounds", options_.rounds);
    json.member("width", subject_.scene.camera.width);
    json.member("height", subject_.scene.camera.height);
    json.member("truth_depth", truth_depth_).member("verdict", verdict_);
    json.member("without_embree", embree_why_not_).member("without_povray", povray_why_not_);
    json.key("points").begin_array(Layout::block);
    for (const WorkPoint& p : points_) {
        json.begin_object().member("family", p.family).member("label", p.label);
        json.member("seconds_a_pixel", p.seconds).member("low", p.low).member("high", p.high);
        put(json, "intensity", p.intensity);
        json.key("pixels_of_other_shape");
        if (std::isfinite(p.other_shape)) {
            json.value(p.other_shape);
        } else {
            json.null();
        }
        json.member("on_front", p.on_front).end_object();
    }
    json.end_array().key("rounding").begin_array(Layout::block);
    for (const Rounding& r : roundings_) {
        json.begin_object(Layout::block).member("arithmetic", r.name);
        put(json, "distance", r.distance);
        put(json, "point", r.place);
        put(json, "intensity", r.intensity);
        json.member("pixels_of_other_shape", static_cast<double>(r.other_shape));
        json.key("direction_after_bounces").begin_array(Layout::block);
        for (const Errors& errors : r.direction) {
            json.begin_object().member("worst", errors.worst);
            json.member("rms", errors.rms()).end_object();
        }
        json.end_array().end_object();
    }
    json.end_array().end_object();
    write_output(file, json.take());
}

/// The scenes of lessons, the examples, those made here, and the SPD's where they are.
std::vector<std::pair<std::string, std::filesystem::path>> scene_files(const Options& options) {
    std::vector<std::pair<std::string, std::filesystem::path>> files;
    const std::filesystem::path lessons = RAYTREE_LESSONS_DIR;
    const std::filesystem::path folders[] = {lessons,
                                             std::filesystem::path(RAYTREE_DATA_DIR) / "scenes",
                                             std::filesystem::path(options.data) / "nff"};
    for (const std::filesystem::path& folder : folders) {
        std::error_code none;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, none)) {
            const std::string name = entry.path().filename().string();
            const bool is_scene =
                entry.path().extension() == ".json" || entry.path().extension() == ".nff";
            if (is_scene && name != "lesson.json" && !name.ends_with(".tree.json")) {
                const bool of_lesson = folder == lessons;
                files.emplace_back(
                    (of_lesson ? entry.path().parent_path().filename().string() + "-" : "") +
                        entry.path().stem().string(),
                    entry.path());
            }
        }
    }
    std::ranges::sort(files);
    return files;
}

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
    for (const auto& [name, file] : scene_files(options)) {
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
