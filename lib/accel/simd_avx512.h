#pragma once

#include <immintrin.h>

#include <bit>
#include <cstddef>
#include <cstdint>

/// Eight floats side by side with AVX-512's masks and its packing of lanes; see simd_plain.h.
/// Registers of eight floats, since wider ones slow some processors down.
namespace raytree::avx512 {

#include "accel/simd_avx.inl"

inline unsigned less_equal(const F8& a, const F8& b) {
    return _mm256_cmp_ps_mask(a.v, b.v, _CMP_LE_OQ);
}

inline std::size_t append(const F8& near, const std::uint32_t* ref, unsigned met,
                          const std::uint32_t* order, unsigned shift, float* nears,
                          std::uint32_t* refs) {
    // Of its lanes a permutation looks at the lowest three bits alone.
    const __m256i from = _mm256_srli_epi32(
        _mm256_loadu_si256(reinterpret_cast<const __m256i*>(order)), static_cast<int>(shift));
    const __m256i bit =
        _mm256_sllv_epi32(_mm256_set1_epi32(1), _mm256_and_si256(from, _mm256_set1_epi32(7)));
    const __mmask8 mask = _mm256_test_epi32_mask(bit, _mm256_set1_epi32(static_cast<int>(met)));
    const __m256i children = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(ref));
    _mm256_storeu_ps(nears, _mm256_maskz_compress_ps(mask, _mm256_permutexvar_ps(from, near.v)));
    _mm256_storeu_si256(
        reinterpret_cast<__m256i*>(refs),
        _mm256_maskz_compress_epi32(mask, _mm256_permutexvar_epi32(from, children)));
    return static_cast<std::size_t>(std::popcount(met));
}

inline std::size_t append_unordered(const std::uint32_t* ref, unsigned met, std::uint32_t* refs) {
    const __m256i children = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(ref));
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(refs),
                        _mm256_maskz_compress_epi32(static_cast<__mmask8>(met), children));
    return static_cast<std::size_t>(std::popcount(met));
}

}  // namespace raytree::avx512
