// The instruction set: which registers there are, and what one instruction does that xsimd 8 does
// with several or rounds otherwise. Nothing else in Glint knows more of it than max_lanes.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

// GCC 12 takes the undefined pass-through operand of its own AVX-512 intrinsics for a mistake.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wuninitialized"
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <xsimd/xsimd.hpp>
#pragma GCC diagnostic pop

namespace glint {

// The widest register that this build may use.
#if XSIMD_WITH_AVX512BW
inline constexpr int max_lanes = 16;
inline constexpr const char* instruction_set = "avx512";
#elif XSIMD_WITH_FMA3_AVX2
inline constexpr int max_lanes = 8;
inline constexpr const char* instruction_set = "avx2";
#elif XSIMD_WITH_NEON64
inline constexpr int max_lanes = 4;
inline constexpr const char* instruction_set = "neon";
#else
inline constexpr int max_lanes = 4;
inline constexpr const char* instruction_set = "sse4.2";
#endif

namespace simd {

template <int N>
struct Architecture;
#if XSIMD_WITH_NEON64
template <>
struct Architecture<4> : std::type_identity<xsimd::neon64> {};
#else
template <>
struct Architecture<4> : std::type_identity<xsimd::sse4_2> {};
#endif
#if XSIMD_WITH_FMA3_AVX2
template <>
struct Architecture<8> : std::type_identity<xsimd::fma3<xsimd::avx2>> {};
#endif
#if XSIMD_WITH_AVX512BW
template <>
struct Architecture<16> : std::type_identity<xsimd::avx512bw> {};
#endif
template <int N>
using Floats = xsimd::batch<float, typename Architecture<N>::type>;
template <int N>
using Ints = xsimd::batch<std::int32_t, typename Architecture<N>::type>;
template <int N>
using Bools = xsimd::batch_bool<float, typename Architecture<N>::type>;

// Answers about integers as answers about floats.
template <class A>
xsimd::batch_bool<float, A> as_bools(xsimd::batch_bool<std::int32_t, A> m) {
    return std::bit_cast<xsimd::batch_bool<float, A>>(m);
}

// ---- what any register can do -----------------------------------------------------------------

#if defined(__FMA__) || defined(__ARM_FEATURE_FMA)
inline float fma(float a, float b, float c) {
    return __builtin_fmaf(a, b, c);
}
#else
template <class F>
F fma(F a, F b, F c) {  // the library's rounds once, and takes fifty times as long
    return a * b + c;
}
#endif

template <class F>
F sqrt(F a) {
    return xsimd::sqrt(a);
}
template <class F>
F min(F a, F b) {
    return xsimd::min(a, b);
}
template <class F>
F max(F a, F b) {
    return xsimd::max(a, b);
}

template <class T, class I>
xsimd::batch<T, typename I::arch_type> gather(const T* from, I index) {
    alignas(64) std::int32_t at[I::size];
    alignas(64) T value[I::size];
    index.store_aligned(at);
    for (std::size_t i = 0; i < I::size; ++i) {
        value[i] = from[at[i]];
    }
    return xsimd::batch<T, typename I::arch_type>::load_aligned(value);
}

template <class I>
xsimd::batch<float, typename I::arch_type> lookup16(const float* table, I index) {
    return gather(table, index & I(15));
}

template <class I>
int store_compressed(std::int32_t* to, std::uint32_t lanes, I a) {
    alignas(64) std::int32_t value[I::size];
    a.store_aligned(value);
    int count = 0;
    for (std::size_t i = 0; i < I::size; ++i) {  // no branch to mispredict
        to[count] = value[i];
        count += static_cast<int>(lanes >> i & 1U);
    }
    return count;
}

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
inline std::uint32_t lane_bits(Bools<4> m) {
    return static_cast<std::uint32_t>(_mm_movemask_ps(m));
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
inline Floats<8> lookup16(const float* table, Ints<8> index) {
    const __m256 low = _mm256_permutevar8x32_ps(_mm256_loadu_ps(table), index);
    const __m256 high = _mm256_permutevar8x32_ps(_mm256_loadu_ps(table + 8), index);
    return _mm256_blendv_ps(low, high, _mm256_castsi256_ps(_mm256_slli_epi32(index, 28)));
}
inline std::uint32_t lane_bits(Bools<8> m) {
    return static_cast<std::uint32_t>(_mm256_movemask_ps(m));
}
// For each set of answering lanes: which lane comes first, second, ... one a byte.
inline constexpr auto lane_order = [] {
    std::array<std::uint64_t, 256> order{};
    for (std::uint32_t lanes = 0; lanes < 256; ++lanes) {
        int bit = 0;
        for (std::uint32_t rest = lanes; rest != 0; rest &= rest - 1, bit += 8) {
            order[lanes] |= static_cast<std::uint64_t>(std::countr_zero(rest)) << bit;
        }
    }
    return order;
}();
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
inline Floats<16> lookup16(const float* table, Ints<16> index) {
    return _mm512_permutexvar_ps(index, _mm512_loadu_ps(table));
}
inline std::uint32_t lane_bits(Bools<16> m) {
    return static_cast<std::uint32_t>(m.data);
}
inline int store_compressed(std::int32_t* to, std::uint32_t lanes, Ints<16> a) {
    _mm512_storeu_si512(to, _mm512_maskz_compress_epi32(static_cast<__mmask16>(lanes), a));
    return std::popcount(lanes);
}
#endif

}  // namespace simd

// While it lives, numbers below 2^-126 count as 0 in this thread. They are darker than anything
// that is seen, and slow: a highlight that fades away took half as long again.
class FlushSubnormals {
  public:
#if XSIMD_WITH_NEON64
    FlushSubnormals() {
        asm volatile("mrs %0, fpcr" : "=r"(saved_));
        asm volatile("msr fpcr, %0" : : "r"(saved_ | 1U << 24));  // FZ
    }
    ~FlushSubnormals() {
        asm volatile("msr fpcr, %0" : : "r"(saved_));
    }
#else
    FlushSubnormals() : saved_(_mm_getcsr()) {
        _mm_setcsr(_mm_getcsr() | 0x8040U);
    }  // FTZ, DAZ
    ~FlushSubnormals() {
        _mm_setcsr(static_cast<unsigned>(saved_));
    }
#endif
    FlushSubnormals(const FlushSubnormals&) = delete;
    FlushSubnormals& operator=(const FlushSubnormals&) = delete;

  private:
    std::uint64_t saved_ = 0;
};

}  // namespace glint
