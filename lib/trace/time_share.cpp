#include "trace/time_share.h"

#include <algorithm>
#include <array>
#include <ctime>

#include "accel/lecture_hierarchy.h"
#include "trace/ray_list.h"

namespace raytree {
namespace {

constexpr std::size_t most_pixels = 4096;
constexpr std::size_t brute_force_tests = 20'000'000;  // about a tenth of a second
constexpr int repeats = 3;

double thread_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The least of a few runs: what disturbs only makes a run longer.
template <class Work> double time_of(Work work) {
    double least = Real<double>::infinity;
    for (int k = 0; k < repeats; ++k) {
        const double start = thread_seconds();
        work();
        least = std::min(least, thread_seconds() - start);
    }
    return least;
}

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
    share.all = time_of([&] { trace_some(world, stride); });
    share.intersection = time_of([&] {
        NoTestCount count;
        ask_again(world.shapes, rays, count, hits);
    });
    const LectureIntersector every(LectureKind::brute_force, world.shapes.shapes());
    const std::size_t shapes = std::max<std::size_t>(1, world.shapes.shapes().size());
    const std::size_t few = std::clamp<std::size_t>(brute_force_tests / shapes, 1, rays.size());
    const std::size_t every_nth = std::max<std::size_t>(1, rays.size() / few);
    std::vector<ListedRay<double>> some;
    for (std::size_t k = 0; k < rays.size(); k += every_nth) {
        some.push_back(rays[k]);
    }
    LectureCount tests;
    const double brute_force = time_of([&] { ask_again(every, some, tests, hits); });
    share.brute_force_intersection =
        brute_force * static_cast<double>(rays.size()) / static_cast<double>(some.size());
    return share;
}

}  // namespace raytree
