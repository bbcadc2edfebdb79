// Eight floats side by side in a register of AVX; see simd_plain.h. Included by one file for each
// instruction set, inside a namespace of its own.

struct F8 {
    __m256 v;

    static F8 load(const float* p) { return {_mm256_loadu_ps(p)}; }
    static F8 all(float x) { return {_mm256_set1_ps(x)}; }
    void store(float* p) const { _mm256_storeu_ps(p, v); }
};

inline F8 operator+(const F8& a, const F8& b) { return {_mm256_add_ps(a.v, b.v)}; }
inline F8 operator-(const F8& a, const F8& b) { return {_mm256_sub_ps(a.v, b.v)}; }
inline F8 operator*(const F8& a, const F8& b) { return {_mm256_mul_ps(a.v, b.v)}; }
inline F8 min(const F8& a, const F8& b) { return {_mm256_min_ps(a.v, b.v)}; }
inline F8 max(const F8& a, const F8& b) { return {_mm256_max_ps(a.v, b.v)}; }
inline F8 abs(const F8& a) { return {_mm256_andnot_ps(_mm256_set1_ps(-0.0F), a.v)}; }
/// `b`, or -b where a is negative.
inline F8 with_sign_of(const F8& a, const F8& b) {
    return {_mm256_xor_ps(b.v, _mm256_and_ps(a.v, _mm256_set1_ps(-0.0F)))};
}
inline F8 square_root(const F8& a) { return {_mm256_sqrt_ps(a.v)}; }
inline F8 multiply_add(const F8& a, const F8& b, const F8& c) {
    return {_mm256_fmadd_ps(a.v, b.v, c.v)};
}
inline F8 multiply_subtract(const F8& a, const F8& b, const F8& c) {
    return {_mm256_fmsub_ps(a.v, b.v, c.v)};
}
inline F8 subtract_product(const F8& c, const F8& a, const F8& b) {
    return {_mm256_fnmadd_ps(a.v, b.v, c.v)};
}
inline float smallest_of(const F8& a) {
    __m128 m = _mm_min_ps(_mm256_castps256_ps128(a.v), _mm256_extractf128_ps(a.v, 1));
    m = _mm_min_ps(m, _mm_movehl_ps(m, m));
    return _mm_cvtss_f32(_mm_min_ss(m, _mm_movehdup_ps(m)));
}
inline float largest_of(const F8& a) {
    __m128 m = _mm_max_ps(_mm256_castps256_ps128(a.v), _mm256_extractf128_ps(a.v, 1));
    m = _mm_max_ps(m, _mm_movehl_ps(m, m));
    return _mm_cvtss_f32(_mm_max_ss(m, _mm_movehdup_ps(m)));
}
