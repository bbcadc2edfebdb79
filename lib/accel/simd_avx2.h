#pragma once

#include <immintrin.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

/// Eight floats side by side with the instructions of AVX2; see simd_plain.h.
namespace raytree::avx2 {

#include "accel/simd_avx.inl"

inline unsigned less_equal(const F8& a, const F8& b) {
    return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(a.v, b.v, _CMP_LE_OQ)));
}

/// For each mask the places of its bits, one a byte, the lowest first.
inline constexpr std::array<std::uint64_t, 256> places_of_bits = [] {
    std::array<std::uint64_t, 256> table{};
    for (unsigned mask = 0; mask < 256; ++mask) {
        unsigned count = 0;
        for (unsigned k = 0; k < 8; ++k) {
            if ((mask >> k & 1) != 0) {
                table[mask] |= static_cast<std::uint64_t>(k) << 8 * count++;
            }
        }
    }
    return table;
}();

inline std::size_t append(const F8& near, const std::uint32_t* ref, unsigned met,
                          const std::uint32_t* order, unsigned shift, float* nears,
                          std::uint32_t* refs) {
    const __m256i order_of_all = _mm256_srli_epi32(
        _mm256_loadu_si256(reinterpret_cast<const __m256i*>(order)), static_cast<int>(shift));
    // The mask in the new order: bit k of `met` for the lane that lane k goes to.
    const __m256i bit = _mm256_sllv_epi32(_mm256_set1_epi32(1),
                                          _mm256_and_si256(order_of_all, _mm256_set1_epi32(7)));
    const __m256i in_order =
        _mm256_cmpeq_epi32(_mm256_and_si256(bit, _mm256_set1_epi32(static_cast<int>(met))), bit);
    const auto mask = static_cast<unsigned>(_mm256_movemask_ps(_mm256_castsi256_ps(in_order)));
    const __m256i kept =
        _mm256_cvtepu8_epi32(_mm_cvtsi64_si128(static_cast<long long>(places_of_bits[mask])));
    const __m256i from = _mm256_permutevar8x32_epi32(order_of_all, kept);
    _mm256_storeu_ps(nears, _mm256_permutevar8x32_ps(near.v, from));
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(refs),
                        _mm256_permutevar8x32_epi32(
                            _mm256_loadu_si256(reinterpret_cast<const __m256i*>(ref)), from));
    return static_cast<std::size_t>(std::popcount(mask));
}

inline std::size_t append_unordered(const std::uint32_t* ref, unsigned met, std::uint32_t* refs) {
    const __m256i from =
        _mm256_cvtepu8_epi32(_mm_cvtsi64_si128(static_cast<long long>(places_of_bits[met])));
    const __m256i children = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(ref));
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(refs),
                        _mm256_permutevar8x32_epi32(children, from));
    return static_cast<std::size_t>(std::popcount(met));
}

}  // namespace raytree::avx2
