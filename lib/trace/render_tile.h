#pragma once

#include "scene/plan.h"
#include "trace/render.h"

namespace raytree {

/// A part of a picture: columns and rows, the ends excluded, at most tile_size of each.
struct PictureTile {
    int begin_i, end_i, begin_j, end_j;
};
inline constexpr int tile_size = 16;

/// Traces the pixels of a tile into the picture.
template <class T> using TileTracer = void (*)(const World<T>&, const PictureTile&, Picture&);

/// That which does nothing that the plan does without, for the processor that the program runs on.
/// The pictures of all of them are the same.
template <class T> TileTracer<T> tile_tracer(const Plan& plan);

/// Those compiled for AVX2 and fused multiply-adds.
TileTracer<double> tile_tracer_avx2(const Plan& plan);

}  // namespace raytree
