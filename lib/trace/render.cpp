#include "trace/render.h"

#include <tbb/enumerable_thread_specific.h>

#include <chrono>

#include "trace/picture_tiles.h"
#include "trace/render_tile.h"
#include "trace/tracer.h"

namespace raytree {
namespace {

std::size_t place(int width, int i, int j) {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(i);
}

template <class T> Picture black(const World<T>& world) {
    const Camera& camera = world.scene().camera;
    return {camera.width, camera.height,
            std::vector<Rgb<double>>(place(camera.width, 0, camera.height))};
}

template <class T> double value_of(Measure measure, const CountingRecorder<T>& recorder,
                                   const RayCounts& before, std::size_t tests_before,
                                   std::chrono::nanoseconds time) {
    switch (measure) {
        case Measure::rays:
            return static_cast<double>(recorder.counts.rays() - before.rays());
        case Measure::levels:
            return recorder.levels;
        case Measure::tests:
            return static_cast<double>(recorder.tests.tests - tests_before);
        case Measure::nanoseconds:
            return static_cast<double>(time.count());
        default:
            return static_cast<double>(recorder.ended);
    }
}

}  // namespace

template <class T> Picture render(const World<T>& world, const RenderOptions& options) {
    Picture picture = black(world);
    world.shapes.complete();
    const TileTracer<T> trace = tile_tracer<T>(plan_of(world.scene()));
    for_each_tile(picture.width, picture.height, options, [&](const Tile& t) {
        trace(world, {t.cols().begin(), t.cols().end(), t.rows().begin(), t.rows().end()}, picture);
    });
    return picture;
}

template <class T>
Measurement render_measured(const World<T>& world, Measure measure, const RenderOptions& options) {
    using Clock = std::chrono::steady_clock;
    world.shapes.complete();
    Measurement result{black(world), {}, {}};
    result.map.resize(result.picture.pixels.size());
    tbb::enumerable_thread_specific<RayCounts> counts;
    for_each_tile(result.picture.width, result.picture.height, options, [&](const Tile& t) {
        CountingRecorder<T> recorder;
        Tracer<T, CountingRecorder<T>> tracer(world, recorder);
        for (int j = t.rows().begin(); j < t.rows().end(); ++j) {
            for (int i = t.cols().begin(); i < t.cols().end(); ++i) {
                const std::size_t k = place(result.picture.width, i, j);
                const RayCounts before = recorder.counts;
                const std::size_t tests_before = recorder.tests.tests;
                recorder.begin_tree();
                const auto begin = Clock::now();
                result.picture.pixels[k] = rgb_cast<double>(tracer.trace_pixel(i, j));
                result.map[k] =
                    value_of(measure, recorder, before, tests_before, Clock::now() - begin);
            }
        }
        recorder.counts.tests = recorder.tests.tests;
        counts.local() += recorder.counts;
    });
    result.counts = counts.combine([](RayCounts a, const RayCounts& b) { return a += b; });
    return result;
}

#define RAYTREE_INSTANTIATE(T)                                         \
    template Picture render<T>(const World<T>&, const RenderOptions&); \
    template Measurement render_measured<T>(const World<T>&, Measure, const RenderOptions&);
RAYTREE_INSTANTIATE(float)
RAYTREE_INSTANTIATE(double)
RAYTREE_INSTANTIATE(Quad)
#undef RAYTREE_INSTANTIATE

}  // namespace raytree
