#pragma once

#include <tbb/blocked_range2d.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <atomic>

#include "trace/render.h"
#include "trace/render_tile.h"

namespace raytree {

using Tile = tbb::blocked_range2d<int>;

/// Calls `work(tile)` for all tiles of a picture, on as many threads as asked for.
template <class Work>
void for_each_tile(int width, int height, const RenderOptions& options, Work&& work) {
    std::atomic<std::size_t> done{0};
    const double all = static_cast<double>(width) * height;
    tbb::task_group_context context;
    const auto run_tile = [&](const Tile& t) {
        work(t);
        const std::size_t pixels = t.rows().size() * t.cols().size();
        const std::size_t so_far = done.fetch_add(pixels) + pixels;
        if (options.progress && !options.progress(static_cast<double>(so_far) / all)) {
            context.cancel_group_execution();
        }
    };
    const int threads =
        options.threads > 0 ? options.threads : tbb::this_task_arena::max_concurrency();
    // Without this the library silently gives no more threads than there are cores.
    const tbb::global_control allow(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
    tbb::task_arena arena(threads);
    arena.execute([&] {
        tbb::parallel_for(Tile(0, height, tile_size, 0, width, tile_size), run_tile,
                          tbb::simple_partitioner(), context);
    });
}

}  // namespace raytree
