#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "accel/kernels.h"
#include "accel/simd_plain.h"

namespace raytree::plain {
#include "accel/kernels.inl"
}

namespace raytree {

const Kernels plain_kernels = plain::all_kernels;

const Kernels& kernels() {
#if defined(__x86_64__) && defined(__GNUC__)
    static const bool has_avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    if (has_avx2) {
        return avx2_kernels;
    }
#endif
    return plain_kernels;
}

}  // namespace raytree
