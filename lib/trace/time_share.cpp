#include "trace/time_share.h"

#include <algorithm>

#include "accel/lecture_hierarchy.h"
#include "trace/ray_list.h"
#include "trace/thread_time.h"

namespace raytree {
namespace {

constexpr std::size_t most_pixels = 4096;
constexpr std::size_t brute_force_tests = 20'000'000;  // about a tenth of a second
constexpr int repeats = 3;

void trace_some(const World<double>& world, std::size_t stride) {
    const auto width = static_cast<std::size_t>(world.scene().camera.width);
    const auto height = static_cast<std::size_t>(world.scene().camera.height);
    NoRecorder<double> nothing;
    Tracer<double, NoRecorder<double>> tracer(world, nothing);
    for (std::size_t pixel = 0; pixel < width * height; pixel += stride) {
        tracer.trace_pixel(static_cast<int>(pixel % width), static_cast<int>(pixel / width));
    }
}

/// Asks as the tracer does: a shadow ray whether there is a hit at all, another for the nearest.
template <class Shapes, class Count> void ask_again(const Shapes& shapes,
                                                    std::span<const ListedRay<double>> rays,
                                                    Count& count, std::size_t& hits) {
    for (const ListedRay<double>& ray : rays) {
        if (ray.kind == RayKind::shadow) {
            hits += shapes.any(ray.ray, ray.leaving, ray.interval, count) ? 1 : 0;
        } else {
            hits += shapes.closest(ray.ray, ray.leaving, ray.interval, count) ? 1 : 0;
        }
    }
}

}  // namespace

TimeShare measure_time_share(const World<double>& world) {
    world.shapes.complete();
    const auto pixels = static_cast<std::size_t>(world.scene().camera.width) *
                        static_cast<std::size_t>(world.scene().camera.height);
    const std::size_t stride = std::max<std::size_t>(1, pixels / most_pixels);
    const std::vector<ListedRay<double>> rays = rays_of_picture(world, stride);
    TimeShare share;
    share.rays = rays.size();
    std::size_t hits = 0;
    share.all = thread_time_of([&] { trace_some(world, stride); }, repeats);
    share.intersection = thread_time_of(
        [&] {
            NoTestCount count;
            ask_again(world.shapes, rays, count, hits);
        },
        repeats);
    const LectureIntersector every(LectureKind::brute_force, world.shapes.shapes());
    const std::size_t shapes = std::max<std::size_t>(1, world.shapes.shapes().size());
    const std::size_t few = std::clamp<std::size_t>(brute_force_tests / shapes, 1, rays.size());
    const std::size_t every_nth = std::max<std::size_t>(1, rays.size() / few);
    std::vector<ListedRay<double>> some;
    for (std::size_t k = 0; k < rays.size(); k += every_nth) {
        some.push_back(rays[k]);
    }
    LectureCount tests;
    const double brute_force =
        thread_time_of([&] { ask_again(every, some, tests, hits); }, repeats);
    share.brute_force_intersection =
        brute_force * static_cast<double>(rays.size()) / static_cast<double>(some.size());
    return share;
}

}  // namespace raytree
