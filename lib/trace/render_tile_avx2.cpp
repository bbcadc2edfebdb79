#if defined(__x86_64__) && defined(__GNUC__)

#include <algorithm>
#include <array>
#include <concepts>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "accel/space_between.h"
#include "scene/input_error.h"
#include "trace/media.h"
#include "trace/recorder.h"
#include "trace/render_tile.h"
#include "trace/world.h"

// The tracer is a template over a recorder that this file alone has, and so it is compiled here
// for AVX2 without any other file's use of it; the headers above are for all.
#ifdef __clang__
#pragma clang attribute push(__attribute__((target("avx2,fma"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2,fma")
#endif

#include "trace/tracer.h"

namespace raytree {
namespace avx2 {
#include "trace/render_tile.inl"
}  // namespace avx2

TileTracer<double> tile_tracer_avx2(const Plan& plan) {
    return avx2::choose_tile_tracer<double>(plan);
}

}  // namespace raytree

#ifdef __clang__
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif

#endif
