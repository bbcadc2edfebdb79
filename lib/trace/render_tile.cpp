#include "trace/render_tile.h"

#include <algorithm>
#include <array>
#include <concepts>
#include <span>
#include <vector>

#include "accel/space_between.h"
#include "trace/tracer.h"

namespace raytree {
namespace plain {
#include "trace/render_tile.inl"
}  // namespace plain

// Only double is traced at full speed; the others are to be compared with.
template <class T> TileTracer<T> tile_tracer(const Plan&) { return plain::trace_tile<T, Facts{}>; }

template <> TileTracer<double> tile_tracer<double>(const Plan& plan) {
#if defined(__x86_64__) && defined(__GNUC__)
    if (&kernels() != &plain_kernels) {
        return tile_tracer_avx2(plan);
    }
#endif
    return plain::choose_tile_tracer<double>(plan);
}

template TileTracer<float> tile_tracer<float>(const Plan&);
template TileTracer<Quad> tile_tracer<Quad>(const Plan&);

}  // namespace raytree
