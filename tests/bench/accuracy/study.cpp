#include "accuracy/study.h"

#include <algorithm>
#include <array>

#include "support/embree_tracer.h"
#include "support/povray.h"
#include "support/report.h"

namespace raytree::bench {
namespace {

/// The truth: the reference arithmetic, deeper than anything that is held against it, with no
/// branch too light.
constexpr int deepest_truth = 16;
constexpr int shallowest_truth = 13;
/// How much longer the reference takes than double, roughly: by it the picture's size is chosen.
constexpr double reference_factor = 400;

Scene with(const Scene& scene, int max_depth, double min_weight) {
    Scene result = scene;
    result.settings.max_depth = max_depth;
    result.settings.min_weight = min_weight;
    return result;
}

double size_of(const World<double>& world) {
    Box box;
    for (std::size_t k = 0; k < world.shapes.shapes().size(); ++k) {
        box.include(world.shapes.shapes().bounds(static_cast<PrimitiveId>(k)));
    }
    return length(box.size());
}

}  // namespace

void Study::run() {
    choose_size();
    const Scene deepest = with(subject_.scene, truth_depth_, 0);
    trace_truth(deepest);
    measure_settings(deepest);
    run_povray_too(deepest);
    find_rounding(deepest);
    mark_front(points_);
    verdict_ = verdict_on_default(points_);
}

/// As many pixels and levels as the reference can do in some seconds.
void Study::choose_size() {
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

/// Once: it takes hundreds of times as long as the rest.
void Study::trace_truth(const Scene& deepest) {
    const World<Quad> world(deepest);
    truth_ = all_steps(world);
    const double begin = thread_seconds();
    render(world, {1, {}});
    const double seconds = (thread_seconds() - begin) / pixels();
    WorkPoint point{"arithmetic", "reference", seconds, seconds, seconds, {}, 0};
    point.intensity.count = 1;
    points_.push_back(point);
}

template <class T> void Study::enter(std::vector<Contender>& all, const std::string& family,
                                     const std::string& label, Scene scene) const {
    Contender contender{{family, label}, std::make_unique<Scene>(std::move(scene)), {}};
    auto world = std::make_shared<World<T>>(*contender.scene);
    contender.point.other_shape = static_cast<double>(other_shapes(all_steps(*world), truth_));
    contender.render = [world] { return render(*world, {1, {}}); };
    all.push_back(std::move(contender));
}

void Study::measure_settings(const Scene& deepest) {
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
    enter_embree(all, deepest);
    time(all);
}

void Study::enter_embree(std::vector<Contender>& all, const Scene& deepest) {
    embree_why_not_ = EmbreeTracer::why_not(deepest);
    if (!embree_why_not_.empty()) {
        return;
    }
    const auto tracer = std::make_shared<EmbreeTracer>(deepest);
    Contender embree{{"embree", "Embree"}, nullptr, [tracer] { return tracer->render(); }};
    for_each_pixel(deepest, [&](int i, int j) { embree_steps_.push_back(tracer->steps(i, j)); });
    embree.point.other_shape = static_cast<double>(other_shapes(embree_steps_, truth_));
    all.push_back(std::move(embree));
}

/// All in turn.
void Study::time(std::vector<Contender>& all) {
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

void Study::run_povray_too(const Scene& deepest) {
    povray_why_not_ = povray_why_not(deepest);
    if (!povray_why_not_.empty()) {
        return;
    }
    const PovrayRun run = run_povray(deepest);
    const double seconds = run.seconds_a_pixel;
    points_.push_back(
        {"povray", "POV-Ray", seconds, seconds, seconds, picture_errors(run.picture, truth_, 1)});
}

void Study::find_rounding(const Scene& deepest) {
    const World<double> in_double(deepest);
    const World<float> in_float(deepest);
    const double size = size_of(in_double);
    roundings_.push_back(rounding_of("float", all_steps(in_float), truth_, size));
    if (!embree_steps_.empty()) {
        roundings_.push_back(rounding_of("Embree", embree_steps_, truth_, size));
    }
    roundings_.push_back(rounding_of("double", all_steps(in_double), truth_, size));
}

}  // namespace raytree::bench
