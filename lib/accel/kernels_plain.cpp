#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

#include <glm/gtc/type_ptr.hpp>

#include "accel/kernels.h"
#include "accel/simd_plain.h"
#include "accel/space_between.h"

namespace raytree::plain {
#include "accel/kernels.inl"
}

namespace raytree {

const Kernels plain_kernels = plain::all_kernels;

namespace {

std::vector<const Kernels*> find_runnable() {
    std::vector<const Kernels*> list = {&plain_kernels};
#if defined(__x86_64__) && defined(__GNUC__)
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
        list.push_back(&avx2_kernels);
        if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl")) {
            list.push_back(&avx512_kernels);
        }
    }
#endif
    return list;
}

}  // namespace

std::span<const Kernels* const> runnable_kernels() {
    static const std::vector<const Kernels*> list = find_runnable();
    return list;
}

const Kernels& kernels() {
    static const Kernels& fastest = *runnable_kernels().back();
    return fastest;
}

}  // namespace raytree
