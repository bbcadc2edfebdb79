#include "trace/work_precision.h"

#include <algorithm>
#include <cmath>

#include "trace/counting.h"
#include "trace/thread_time.h"
#include "trace/tracer.h"

namespace raytree {
namespace {

constexpr std::size_t most_pixels = 1024, fewest_pixels = 64;
// That all pixels may take together, about half a second in the reference arithmetic. Counted, not
// timed: the same pixels, and with them the same errors, on every machine.
constexpr double most_rays = 16'000;
constexpr int repeats = 3;
constexpr int most_levels = 12;  // that are shown

/// Which pixels: every `stride`-th of a picture `width` wide.
struct Some {
    std::size_t width = 1, pixels = 1, stride = 1;
};

template <class T, class Recorder>
std::vector<Rgb<T>> trace_some(const World<T>& world, const Some& some, Recorder& recorder) {
    Tracer<T, Recorder> tracer(world, recorder);
    std::vector<Rgb<T>> traced;
    for (std::size_t pixel = 0; pixel < some.pixels; pixel += some.stride) {
        traced.push_back(tracer.trace_pixel(static_cast<int>(pixel % some.width),
                                            static_cast<int>(pixel / some.width)));
    }
    return traced;
}

template <class T> std::vector<Rgb<T>> trace_some(const World<T>& world, const Some& some) {
    NoRecorder<T> nothing;
    return trace_some(world, some, nothing);
}

/// As many pixels as have few enough rays, judged by a few of them.
Some chosen_pixels(const World<double>& world) {
    const Camera& camera = world.scene().camera;
    const auto width = static_cast<std::size_t>(camera.width);
    Some some{width, width * static_cast<std::size_t>(camera.height), 1};
    // Not a divisor of the width where that can be: else all would lie in a few columns.
    const auto stride_for = [&](std::size_t count) {
        const std::size_t stride = std::max<std::size_t>(1, some.pixels / count);
        return stride > 1 && width % stride == 0 ? stride + 1 : stride;
    };
    some.stride = stride_for(fewest_pixels);
    CountingRecorder<double> recorder;
    const std::size_t few = trace_some(world, some, recorder).size();
    const double a_pixel = static_cast<double>(recorder.counts.rays()) / static_cast<double>(few);
    some.stride = stride_for(
        std::clamp(static_cast<std::size_t>(most_rays / a_pixel), fewest_pixels, most_pixels));
    return some;
}

template <class T>
double error_of(const std::vector<Rgb<T>>& own, const std::vector<Rgb<Quad>>& exact) {
    double squares = 0;
    const auto add = [&](T a, Quad b) {
        const auto off = static_cast<double>(Quad(a) - b);
        squares += off * off;
    };
    for (std::size_t k = 0; k < own.size(); ++k) {
        add(own[k].r, exact[k].r);
        add(own[k].g, exact[k].g);
        add(own[k].b, exact[k].b);
    }
    return std::sqrt(squares / (3 * static_cast<double>(own.size())));
}

template <class T> WorkPoint point_of(const std::string& label, const Scene& scene,
                                      const Some& some, const std::vector<Rgb<Quad>>& exact) {
    const World<T> world(scene);
    std::vector<Rgb<T>> traced = trace_some(world, some);  // completes the hierarchy as well
    const double seconds = thread_time_of([&] { traced = trace_some(world, some); }, repeats);
    return {label, seconds / static_cast<double>(traced.size()), error_of(traced, exact)};
}

}  // namespace

WorkPrecision measure_work_precision(const Scene& scene) {
    const Some some = chosen_pixels(World<double>(scene));
    const World<Quad> reference(scene);
    std::vector<Rgb<Quad>> exact;
    const double seconds = thread_time_of([&] { exact = trace_some(reference, some); });
    WorkPrecision all;
    all.pixels = exact.size();
    all.arithmetics = {point_of<float>("float", scene, some, exact),
                       point_of<double>("double", scene, some, exact),
                       {"reference", seconds / static_cast<double>(exact.size()), 0}};
    Scene cut = scene;
    for (int levels = 1; levels < std::min(scene.settings.max_depth, most_levels + 1); ++levels) {
        cut.settings.max_depth = levels;
        all.levels.push_back(point_of<double>(
            std::to_string(levels) + (levels == 1 ? " level" : " levels"), cut, some, exact));
    }
    return all;
}

}  // namespace raytree
