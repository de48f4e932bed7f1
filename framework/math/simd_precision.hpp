// Where the instruction set is faster for being less exact: estimates to start from, and subnormal
// numbers taken for 0.
#pragma once

#include "framework/math/simd.hpp"

#include <cstddef>
#include <cstdint>

namespace glint::simd {

// Estimates of 14 bits, which a step of Newton's iteration doubles; what that saves against root
// and quotient: docs/charts/families/normalise.cpp. The same bits in registers of any width.
#if defined(__AVX512VL__)
inline __m512 root_estimate(__m512 a) {
    return _mm512_rsqrt14_ps(a);
}
inline __m256 root_estimate(__m256 a) {
    return _mm256_rsqrt14_ps(a);
}
inline __m128 root_estimate(__m128 a) {
    return _mm_rsqrt14_ps(a);
}
inline __m512 quotient_estimate(__m512 a) {
    return _mm512_rcp14_ps(a);
}
inline __m256 quotient_estimate(__m256 a) {
    return _mm256_rcp14_ps(a);
}
inline __m128 quotient_estimate(__m128 a) {
    return _mm_rcp14_ps(a);
}
inline float quotient_estimate(float a) {
    return _mm_cvtss_f32(_mm_rcp14_ss(_mm_setzero_ps(), _mm_set_ss(a)));
}
template <class F>
F inverse_sqrt_estimate(F a) {
    return root_estimate(a);
}
template <class F>
F reciprocal(F a) {
    const F y = quotient_estimate(a);
    return fma(y, fma(-a, y, F(1.0F)), y);
}
#else
template <class F>
F inverse_sqrt_estimate(F a) {
    return quotient(F(1.0F), sqrt(a));
}
template <class F>
F reciprocal(F a) {
    return quotient(F(1.0F), a);
}
#endif

// a b - c d, off by less than 2 units in its last place even where it cancels (Kahan; Jeannerod,
// Louvet and Muller 2013).
#if defined(__FMA__) || XSIMD_WITH_NEON64
template <class F>
F difference_of_products(F a, F b, F c, F d) {
    const F cd = c * d;
    return fma(a, b, -cd) + fma(-c, d, cd);  // the second: what cd lost by rounding
}
#else
inline float difference_of_products(float a, float b, float c, float d) {
    const auto product = [](float x, float y) { return static_cast<double>(x) * y; };
    return static_cast<float>(product(a, b) - product(c, d));
}
template <class F>
F difference_of_products(F a, F b, F c, F d) {
    alignas(64) float r[4][F::size];
    a.store_aligned(r[0]);
    b.store_aligned(r[1]);
    c.store_aligned(r[2]);
    d.store_aligned(r[3]);
    for (std::size_t i = 0; i < F::size; ++i) {
        r[0][i] = difference_of_products(r[0][i], r[1][i], r[2][i], r[3][i]);
    }
    return F::load_aligned(r[0]);
}
#endif

// A thread's own word of how it computes.
#if XSIMD_WITH_NEON64
inline constexpr std::uint64_t flush_to_zero = 1U << 24;  // FZ
inline std::uint64_t control_word() {
    std::uint64_t word = 0;
    asm volatile("mrs %0, fpcr" : "=r"(word));
    return word;
}
inline void set_control_word(std::uint64_t word) {
    asm volatile("msr fpcr, %0" : : "r"(word));
}
#else
inline constexpr std::uint64_t flush_to_zero = 0x8040;  // FTZ, DAZ
inline std::uint64_t control_word() {
    return _mm_getcsr();
}
inline void set_control_word(std::uint64_t word) {
    _mm_setcsr(static_cast<unsigned>(word));
}
#endif

}  // namespace glint::simd
