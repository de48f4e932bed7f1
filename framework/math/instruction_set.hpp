// The instruction set without its registers: how wide they are; and one float, rounded and
// estimated as they are, to the bit.
#pragma once

#include <bit>
#include <cstdint>

#if defined(__AVX512VL__)
// GCC 12 takes the undefined pass-through operand of its own AVX-512 intrinsics for a mistake.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wuninitialized"
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <immintrin.h>
#pragma GCC diagnostic pop
#endif

namespace glint {

// The widest register that this build may use.
#if defined(__AVX512BW__)
inline constexpr int max_lanes = 16;
inline constexpr const char* instruction_set = "avx512";
#elif defined(__AVX2__) && defined(__FMA__)
inline constexpr int max_lanes = 8;
inline constexpr const char* instruction_set = "avx2";
#else
inline constexpr int max_lanes = 4;
#if defined(__aarch64__)
inline constexpr const char* instruction_set = "neon";
#else
inline constexpr const char* instruction_set = "sse4.2";
#endif
#endif

namespace simd {

inline float sqrt(float a) {
    return __builtin_sqrtf(a);
}

#if defined(__FMA__) || defined(__ARM_FEATURE_FMA)
inline float fma(float a, float b, float c) {
    return __builtin_fmaf(a, b, c);
}
#else
inline float fma(float a, float b, float c) {  // the library's rounds once, fifty times as slowly
    return a * b + c;
}
#endif

#if defined(__AVX512VL__)
inline float inverse_sqrt_estimate(float a) {
    return _mm_cvtss_f32(_mm_rsqrt14_ss(_mm_setzero_ps(), _mm_set_ss(a)));
}
#else
inline float inverse_sqrt_estimate(float a) {
    return 1.0F / sqrt(a);
}
#endif

inline float scale(float a, float k) {
    const bool small = k < -125.0F;
    const std::int32_t exponent = static_cast<std::int32_t>(k) + (small ? 24 : 0);
    const std::int32_t bits = std::bit_cast<std::int32_t>(a) + exponent * (1 << 23);
    return std::bit_cast<float>(bits) * (small ? 0x1p-24F : 1.0F);
}

}  // namespace simd
}  // namespace glint
