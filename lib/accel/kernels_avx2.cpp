#if defined(__x86_64__) && defined(__GNUC__)

#include <immintrin.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <memory>
#include <numeric>
#include <utility>

#include <glm/gtc/type_ptr.hpp>

#include "accel/kernels.h"
#include "accel/space_between.h"

// All that follows is compiled for AVX2, and nothing that other files compile as well: what the
// headers above define was declared before.
#ifdef __clang__
#pragma clang attribute push(__attribute__((target("avx2,fma"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2,fma")
#endif

#include "accel/simd_avx2.h"

namespace raytree::avx2 {
#include "accel/kernels.inl"
}

#ifdef __clang__
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif

namespace raytree {

const Kernels avx2_kernels = avx2::all_kernels;

}  // namespace raytree

#endif
