// The instruction set's registers: what one instruction does that xsimd 8 does with several or
// rounds otherwise. Nothing else that computes but simd_precision.hpp, and instruction_set.hpp for
// one float, knows more of it than max_lanes.
#pragma once

#include "framework/math/registers.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace glint {

static_assert(max_lanes == (XSIMD_WITH_AVX512BW ? 16 : XSIMD_WITH_FMA3_AVX2 ? 8 : 4));

namespace simd {

using Narrow = std::conditional_t<XSIMD_WITH_NEON64, xsimd::neon64, xsimd::sse4_2>;
using Wide = std::conditional_t<XSIMD_WITH_FMA3_AVX2, xsimd::fma3<xsimd::avx2>, void>;
using Widest = std::conditional_t<XSIMD_WITH_AVX512BW, xsimd::avx512bw, void>;
template <int N>
using Architecture = std::conditional_t<N == 4, Narrow, std::conditional_t<N == 8, Wide, Widest>>;
template <int N>
using Floats = xsimd::batch<float, Architecture<N>>;
template <int N>
using Ints = xsimd::batch<std::int32_t, Architecture<N>>;
template <int N>
using Bools = xsimd::batch_bool<float, Architecture<N>>;

#if !defined(__FMA__) && !defined(__ARM_FEATURE_FMA)
template <class F>
F fma(F a, F b, F c) {  // as that of one float
    return a * b + c;
}
#endif

// ---- 4 lanes ----------------------------------------------------------------------------------

#if XSIMD_WITH_NEON64
inline Floats<4> fma(Floats<4> a, Floats<4> b, Floats<4> c) {
    return vfmaq_f32(c, a, b);
}
inline Floats<4> sqrt(Floats<4> a) {  // xsimd's is approximate
    return vsqrtq_f32(a);
}
inline Floats<4> min(Floats<4> a, Floats<4> b) {  // its own min returns NaN if either is
    return vbslq_f32(vcltq_f32(a, b), a, b);
}
inline Floats<4> max(Floats<4> a, Floats<4> b) {
    return vbslq_f32(vcgtq_f32(a, b), a, b);
}
inline std::uint32_t lane_bits(Bools<4> m) {
    const uint32x4_t weights = {1, 2, 4, 8};
    return vaddvq_u32(vandq_u32(m, weights));
}
#else
#if defined(__FMA__)
inline Floats<4> fma(Floats<4> a, Floats<4> b, Floats<4> c) {
    return _mm_fmadd_ps(a, b, c);
}
#endif
inline void store_streaming(std::int32_t* to, Ints<4> a) {
    _mm_stream_si128(reinterpret_cast<__m128i*>(to), a);
}
inline std::uint32_t lane_bits(Bools<4> m) {
    return static_cast<std::uint32_t>(_mm_movemask_ps(m));
}
template <>
inline Rows<Floats<4>> load_rows(const float* const* row) {
    __m128 a = _mm_loadu_ps(row[0]);
    __m128 b = _mm_loadu_ps(row[1]);
    __m128 c = _mm_loadu_ps(row[2]);
    __m128 d = _mm_loadu_ps(row[3]);
    _MM_TRANSPOSE4_PS(a, b, c, d);
    return {a, b, c, d};
}
#endif

// ---- 8 lanes ----------------------------------------------------------------------------------

#if XSIMD_WITH_FMA3_AVX2
inline Floats<8> fma(Floats<8> a, Floats<8> b, Floats<8> c) {
    return _mm256_fmadd_ps(a, b, c);
}
inline Floats<8> gather(const float* from, Ints<8> index) {
    return _mm256_i32gather_ps(from, index, 4);
}
inline Ints<8> gather(const std::int32_t* from, Ints<8> index) {
    return _mm256_i32gather_epi32(from, index, 4);
}
inline Floats<8> lookup(const float* low, const float* high, Ints<8> index) {
    const __m256 a = _mm256_permutevar8x32_ps(_mm256_loadu_ps(low), index);
    const __m256 b = _mm256_permutevar8x32_ps(_mm256_loadu_ps(high), index);
    return _mm256_blendv_ps(a, b, _mm256_castsi256_ps(_mm256_slli_epi32(index, 28)));
}
inline Floats<8> lookup16(const float* table, Ints<8> index) {
    return lookup(table, table + 8, index);
}
inline Rows<Floats<8>> transposed(const Rows<Floats<8>>& r) {  // within the halves
    const __m256 a = _mm256_unpacklo_ps(r[0], r[1]);
    const __m256 b = _mm256_unpacklo_ps(r[2], r[3]);
    const __m256 c = _mm256_unpackhi_ps(r[0], r[1]);
    const __m256 d = _mm256_unpackhi_ps(r[2], r[3]);
    return {_mm256_shuffle_ps(a, b, 0x44), _mm256_shuffle_ps(a, b, 0xee),
            _mm256_shuffle_ps(c, d, 0x44), _mm256_shuffle_ps(c, d, 0xee)};
}
template <>
inline Rows<Floats<8>> load_rows(const float* const* row) {
    Rows<Floats<8>> r;
    for (std::size_t i = 0; i < 4; ++i) {
        r[i] = _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(row[i])),
                                    _mm_loadu_ps(row[i + 4]), 1);
    }
    return transposed(r);
}
template <>
inline void store_rows(float* to, const Rows<Floats<8>>& columns) {
    const Rows<Floats<8>> r = transposed(columns);
    for (std::size_t i = 0; i < 4; ++i) {
        _mm_storeu_ps(to + 4 * i, _mm256_castps256_ps128(r[i]));
        _mm_storeu_ps(to + 4 * i + 16, _mm256_extractf128_ps(r[i], 1));
    }
}
template <>
inline Ints<8> load_fours(const std::int32_t* from, std::ptrdiff_t stride) {
    return _mm256_loadu2_m128i(reinterpret_cast<const __m128i*>(from + stride),
                               reinterpret_cast<const __m128i*>(from));
}
inline void store_streaming(std::int32_t* to, Ints<8> a) {
    _mm256_stream_si256(reinterpret_cast<__m256i*>(to), a);
}
inline std::uint32_t lane_bits(Bools<8> m) {
    return static_cast<std::uint32_t>(_mm256_movemask_ps(m));
}
inline int store_compressed(std::int32_t* to, std::uint32_t lanes, Ints<8> a) {
    const __m256i order =
        _mm256_cvtepu8_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(&lane_order[lanes])));
    Ints<8>(_mm256_permutevar8x32_epi32(a, order)).store_unaligned(to);
    return std::popcount(lanes);
}
#endif

// ---- 16 lanes ---------------------------------------------------------------------------------

#if XSIMD_WITH_AVX512BW
inline Floats<16> fma(Floats<16> a, Floats<16> b, Floats<16> c) {
    return _mm512_fmadd_ps(a, b, c);
}
inline Floats<16> gather(const float* from, Ints<16> index) {
    return _mm512_i32gather_ps(index, from, 4);
}
inline Ints<16> gather(const std::int32_t* from, Ints<16> index) {
    return _mm512_i32gather_epi32(index, from, 4);
}
inline Floats<16> scale(Floats<16> a, Floats<16> k) {
    return _mm512_scalef_ps(a, k);
}
inline Floats<16> lookup16(const float* table, Ints<16> index) {
    return _mm512_permutexvar_ps(index, _mm512_loadu_ps(table));
}
inline Floats<16> lookup(const float* low, const float* high, Ints<16> index) {
    return _mm512_permutex2var_ps(_mm512_loadu_ps(low), index, _mm512_loadu_ps(high));
}
inline Rows<Floats<16>> transposed(const Rows<Floats<16>>& r) {  // within the quarters
    const __m512 a = _mm512_unpacklo_ps(r[0], r[1]);
    const __m512 b = _mm512_unpacklo_ps(r[2], r[3]);
    const __m512 c = _mm512_unpackhi_ps(r[0], r[1]);
    const __m512 d = _mm512_unpackhi_ps(r[2], r[3]);
    return {_mm512_shuffle_ps(a, b, 0x44), _mm512_shuffle_ps(a, b, 0xee),
            _mm512_shuffle_ps(c, d, 0x44), _mm512_shuffle_ps(c, d, 0xee)};
}
template <>
inline Rows<Floats<16>> load_rows(const float* const* row) {
    Rows<Floats<16>> r;
    for (std::size_t i = 0; i < 4; ++i) {
        __m512 quarters = _mm512_castps128_ps512(_mm_loadu_ps(row[i]));
        quarters = _mm512_insertf32x4(quarters, _mm_loadu_ps(row[i + 4]), 1);
        quarters = _mm512_insertf32x4(quarters, _mm_loadu_ps(row[i + 8]), 2);
        r[i] = _mm512_insertf32x4(quarters, _mm_loadu_ps(row[i + 12]), 3);
    }
    return transposed(r);
}
template <>
inline void store_rows(float* to, const Rows<Floats<16>>& columns) {
    const Rows<Floats<16>> r = transposed(columns);
    for (std::size_t i = 0; i < 4; ++i) {
        _mm_storeu_ps(to + 4 * i, _mm512_castps512_ps128(r[i]));
        _mm_storeu_ps(to + 4 * i + 16, _mm512_extractf32x4_ps(r[i], 1));
        _mm_storeu_ps(to + 4 * i + 32, _mm512_extractf32x4_ps(r[i], 2));
        _mm_storeu_ps(to + 4 * i + 48, _mm512_extractf32x4_ps(r[i], 3));
    }
}
template <>
inline Ints<16> load_fours(const std::int32_t* from, std::ptrdiff_t stride) {
    const auto low = load_fours<Ints<8>>(from, stride);
    const auto high = load_fours<Ints<8>>(from + 2 * stride, stride);
    return _mm512_inserti64x4(_mm512_castsi256_si512(low), high, 1);
}
inline void store_streaming(std::int32_t* to, Ints<16> a) {
    _mm512_stream_si512(reinterpret_cast<__m512i*>(to), a);
}
// The empty asm keeps GCC 12 from folding the widening into the comparison: spilled, that would
// store 16 bits and load 32.
inline std::uint32_t lane_bits(Bools<16> m) {
    __mmask16 mask = m.data;
    asm("" : "+k"(mask));
    return mask;
}
inline int store_compressed(std::int32_t* to, std::uint32_t lanes, Ints<16> a) {
    _mm512_storeu_si512(to, _mm512_maskz_compress_epi32(static_cast<__mmask16>(lanes), a));
    return std::popcount(lanes);
}
#endif

// Other threads see what was streamed before only after this.
inline void finish_streaming() {
#if !XSIMD_WITH_NEON64
    _mm_sfence();
#endif
}

}  // namespace simd
}  // namespace glint
