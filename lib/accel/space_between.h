#pragma once

#include "accel/kernels.h"

/// Compiled for each instruction set, as the kernels are.
namespace raytree {

namespace plain {
/// Whether a ray may meet the box of a shape, if its origin and its direction are between those of
/// the queries on every axis, on its way to the farthest of their ends. Directions need not be unit
/// vectors here. True also where it takes long to tell.
bool may_meet_between(const WideBvh& bvh, Kernels::Queries queries);
}  // namespace plain

#if defined(__x86_64__) && defined(__GNUC__)
namespace avx2 {
bool may_meet_between(const WideBvh& bvh, Kernels::Queries queries);
}
namespace avx512 {
bool may_meet_between(const WideBvh& bvh, Kernels::Queries queries);
}
#endif

}  // namespace raytree
