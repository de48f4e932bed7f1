// The SIMD register types: N floats, N 32-bit integers, N answers. All that Glint knows of an
// instruction set is in this file; below it xsimd does the work. Operations act lane by lane.
//
// Every operation has a twin for float, std::int32_t and bool, so that one template text runs
// on one lane or on many: write select(mask, a, b), any(mask), all(mask), never if (mask).
#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>

// GCC 12 takes the undefined pass-through operand of its own AVX-512 intrinsics for a mistake.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wuninitialized"
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <xsimd/xsimd.hpp>
#pragma GCC diagnostic pop

namespace glint {

namespace simd {
template <int N>
struct Architecture;
#if XSIMD_WITH_NEON64
template <>
struct Architecture<4> {
    using type = xsimd::neon64;
};
#elif XSIMD_WITH_FMA3_SSE
template <>
struct Architecture<4> {
    using type = xsimd::fma3<xsimd::sse4_2>;
};
#else
template <>
struct Architecture<4> {
    using type = xsimd::sse4_2;
};
#endif
#if XSIMD_WITH_FMA3_AVX2
template <>
struct Architecture<8> {
    using type = xsimd::fma3<xsimd::avx2>;
};
#endif
#if XSIMD_WITH_AVX512BW
template <>
struct Architecture<16> {
    using type = xsimd::avx512bw;
};
#endif
template <int N>
using Floats = xsimd::batch<float, typename Architecture<N>::type>;
template <int N>
using Ints = xsimd::batch<std::int32_t, typename Architecture<N>::type>;
template <int N>
using Bools = xsimd::batch_bool<float, typename Architecture<N>::type>;
}  // namespace simd

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

// One answer per lane. It is not a bool: an if would have to go two ways at once.
template <int N>
struct Mask {
    simd::Bools<N> v;
    Mask() = default;
    Mask(simd::Bools<N> bools) : v(bools) {}
    Mask(bool all_lanes) : v(all_lanes) {}
    explicit operator bool() const = delete;  // a mask: use select(), any() or all()
    friend Mask operator&(Mask a, Mask b) { return a.v & b.v; }
    friend Mask operator|(Mask a, Mask b) { return a.v | b.v; }
    friend Mask operator!(Mask a) { return ~a.v; }
    Mask& operator&=(Mask b) { return *this = *this & b; }
    Mask& operator|=(Mask b) { return *this = *this | b; }
};

// N signed 32-bit integers; arithmetic wraps, >> keeps the sign.
template <int N>
struct Int {
    simd::Ints<N> v;
    Int() = default;
    Int(simd::Ints<N> ints) : v(ints) {}
    Int(std::int32_t all_lanes) : v(all_lanes) {}
    friend Int operator+(Int a, Int b) { return a.v + b.v; }
    friend Int operator-(Int a, Int b) { return a.v - b.v; }
    friend Int operator*(Int a, Int b) { return a.v * b.v; }
    friend Int operator-(Int a) { return -a.v; }
    friend Int operator&(Int a, Int b) { return a.v & b.v; }
    friend Int operator|(Int a, Int b) { return a.v | b.v; }
    friend Int operator^(Int a, Int b) { return a.v ^ b.v; }
    friend Int operator<<(Int a, int bits) { return a.v << bits; }
    friend Int operator>>(Int a, int bits) { return a.v >> bits; }
    friend Mask<N> operator<(Int a, Int b) { return xsimd::bool_cast(a.v < b.v); }
    friend Mask<N> operator>(Int a, Int b) { return xsimd::bool_cast(a.v > b.v); }
    friend Mask<N> operator<=(Int a, Int b) { return xsimd::bool_cast(a.v <= b.v); }
    friend Mask<N> operator>=(Int a, Int b) { return xsimd::bool_cast(a.v >= b.v); }
    friend Mask<N> operator==(Int a, Int b) { return xsimd::bool_cast(a.v == b.v); }
    friend Mask<N> operator!=(Int a, Int b) { return xsimd::bool_cast(a.v != b.v); }
    Int& operator+=(Int b) { return *this = *this + b; }
    Int& operator-=(Int b) { return *this = *this - b; }
};

// N floats, IEEE 754 single precision, round to nearest.
template <int N>
struct Float {
    simd::Floats<N> v;
    Float() = default;
    Float(simd::Floats<N> floats) : v(floats) {}
    Float(float all_lanes) : v(all_lanes) {}
    explicit Float(double all_lanes) : v(static_cast<float>(all_lanes)) {}
    explicit Float(int all_lanes) : v(static_cast<float>(all_lanes)) {}
    explicit Float(Int<N> ints) : v(xsimd::batch_cast<float>(ints.v)) {}
    friend Float operator+(Float a, Float b) { return a.v + b.v; }
    friend Float operator-(Float a, Float b) { return a.v - b.v; }
    friend Float operator*(Float a, Float b) { return a.v * b.v; }
    friend Float operator/(Float a, Float b) { return a.v / b.v; }
    friend Float operator-(Float a) { return -a.v; }
    friend Mask<N> operator<(Float a, Float b) { return a.v < b.v; }
    friend Mask<N> operator>(Float a, Float b) { return a.v > b.v; }
    friend Mask<N> operator<=(Float a, Float b) { return a.v <= b.v; }
    friend Mask<N> operator>=(Float a, Float b) { return a.v >= b.v; }
    friend Mask<N> operator==(Float a, Float b) { return a.v == b.v; }
    friend Mask<N> operator!=(Float a, Float b) { return a.v != b.v; }
    Float& operator+=(Float b) { return *this = *this + b; }
    Float& operator-=(Float b) { return *this = *this - b; }
    Float& operator*=(Float b) { return *this = *this * b; }
    Float& operator/=(Float b) { return *this = *this / b; }
};

// What belongs together: Lanes<N>::Float, ::Int and ::Mask; plain scalars for one lane.
template <int N>
struct Lanes {
    using Float = glint::Float<N>;
    using Int = glint::Int<N>;
    using Mask = glint::Mask<N>;
};
template <>
struct Lanes<1> {
    using Float = float;
    using Int = std::int32_t;
    using Mask = bool;
};

template <class T>
inline constexpr int lanes_of = 1;
template <int N>
inline constexpr int lanes_of<Float<N>> = N;
template <int N>
inline constexpr int lanes_of<Int<N>> = N;

template <class T>
inline constexpr bool is_lanes = false;
template <int N>
inline constexpr bool is_lanes<Float<N>> = true;

// The integers and the answers that go with a floating-point type: double's integers are 64-bit.
template <class T>
struct Companions {
    using Int = typename Lanes<lanes_of<T>>::Int;
    using Mask = typename Lanes<lanes_of<T>>::Mask;
};
template <class T>
using MaskOf = typename Companions<T>::Mask;
template <class T>
using IntOf = typename Companions<T>::Int;

// ---- select, any, all ----------------------------------------------------------------------

template <int N>
Float<N> select(Mask<N> m, Float<N> yes, Float<N> no) {
    return xsimd::select(m.v, yes.v, no.v);
}
template <int N>
Float<N> select(Mask<N> m, std::type_identity_t<Float<N>> yes, float no) {
    return xsimd::select(m.v, yes.v, Float<N>(no).v);
}
template <int N>
Float<N> select(Mask<N> m, float yes, std::type_identity_t<Float<N>> no) {
    return xsimd::select(m.v, Float<N>(yes).v, no.v);
}
template <int N>
Float<N> select(Mask<N> m, float yes, float no) {
    return xsimd::select(m.v, Float<N>(yes).v, Float<N>(no).v);
}
template <int N>
Int<N> select(Mask<N> m, Int<N> yes, Int<N> no) {
    return xsimd::select(xsimd::bool_cast(m.v), yes.v, no.v);
}
template <class T>
requires std::is_arithmetic_v<T> T select(bool m, T yes, std::type_identity_t<T> no) {
    return m ? yes : no;
}

template <int N>
bool any(Mask<N> m) {
    return xsimd::any(m.v);
}
template <int N>
bool all(Mask<N> m) {
    return xsimd::all(m.v);
}
inline bool any(bool m) {
    return m;
}
inline bool all(bool m) {
    return m;
}

// ---- min, max, sqrt ------------------------------------------------------------------------

// min and max return b where a and b are unordered: max(x, 0) turns NaN into 0.
template <int N>
Float<N> min(Float<N> a, std::type_identity_t<Float<N>> b) {
#if XSIMD_WITH_NEON64
    return select(a < b, a, b);
#else
    return xsimd::min(a.v, b.v);
#endif
}
template <int N>
Float<N> max(Float<N> a, std::type_identity_t<Float<N>> b) {
#if XSIMD_WITH_NEON64
    return select(a > b, a, b);
#else
    return xsimd::max(a.v, b.v);
#endif
}
template <int N>
Int<N> min(Int<N> a, std::type_identity_t<Int<N>> b) {
    return xsimd::min(a.v, b.v);
}
template <int N>
Int<N> max(Int<N> a, std::type_identity_t<Int<N>> b) {
    return xsimd::max(a.v, b.v);
}
template <class T>
requires std::is_arithmetic_v<T> T min(T a, std::type_identity_t<T> b) {
    return a < b ? a : b;
}
template <class T>
requires std::is_arithmetic_v<T> T max(T a, std::type_identity_t<T> b) {
    return a > b ? a : b;
}

template <int N>
Float<N> sqrt(Float<N> a) {
    return xsimd::sqrt(a.v);
}
template <int N>
Float<N> abs(Float<N> a) {
    return xsimd::abs(a.v);
}
template <int N>
Float<N> fma(Float<N> a, Float<N> b, Float<N> c) {  // a*b + c, rounded once where hardware can
    return xsimd::fma(a.v, b.v, c.v);
}

// ---- conversions ---------------------------------------------------------------------------

template <int N>
Int<N> round_to_int(Float<N> a) {  // to nearest, ties to even; |a| < 2^31
    return xsimd::batch_cast<std::int32_t>(xsimd::nearbyint(a.v));
}
template <int N>
Int<N> truncate_to_int(Float<N> a) {  // towards zero; |a| < 2^31
    return xsimd::batch_cast<std::int32_t>(a.v);
}
template <int N>
Float<N> to_float(Int<N> a) {
    return Float<N>(a);
}
template <int N>
Int<N> bits_of(Float<N> a) {
    return xsimd::bitwise_cast<simd::Ints<N>>(a.v);
}
template <int N>
Float<N> float_from_bits(Int<N> a) {
    return xsimd::bitwise_cast<simd::Floats<N>>(a.v);
}
inline std::int32_t round_to_int(float a) {
    return static_cast<std::int32_t>(__builtin_rintf(a));
}
inline std::int32_t truncate_to_int(float a) {
    return static_cast<std::int32_t>(a);
}
inline float to_float(std::int32_t a) {
    return static_cast<float>(a);
}
inline std::int32_t bits_of(float a) {
    return std::bit_cast<std::int32_t>(a);
}
inline float float_from_bits(std::int32_t a) {
    return std::bit_cast<float>(a);
}

// ---- memory --------------------------------------------------------------------------------

// load and store move N consecutive values; any alignment.
template <class T>
requires is_lanes<T> T load(const float* from) {
    return simd::Floats<lanes_of<T>>::load_unaligned(from);
}
template <class T>
requires std::same_as<T, Int<lanes_of<T>>> T load(const std::int32_t* from) {
    return simd::Ints<lanes_of<T>>::load_unaligned(from);
}
template <class T>
requires std::is_arithmetic_v<T> T load(const T* from) {
    return *from;
}
template <int N>
void store(float* to, Float<N> a) {
    a.v.store_unaligned(to);
}
template <int N>
void store(std::int32_t* to, Int<N> a) {
    a.v.store_unaligned(to);
}
template <class T>
requires std::is_arithmetic_v<T>
void store(T* to, T a) {
    *to = a;
}

// 0, 1, 2, ... one number a lane.
template <class T>
T iota() {
    if constexpr (std::is_arithmetic_v<T>) {
        return T{0};
    } else {
        alignas(64) static constexpr std::int32_t numbers[] = {0, 1, 2,  3,  4,  5,  6,  7,
                                                               8, 9, 10, 11, 12, 13, 14, 15};
        const auto ints = load<Int<lanes_of<T>>>(numbers);
        if constexpr (is_lanes<T>) {
            return to_float(ints);
        } else {
            return ints;
        }
    }
}

// from[index] for each lane; every index must be in range.
template <int N>
Float<N> gather(const float* from, Int<N> index) {
#if XSIMD_WITH_AVX512BW
    if constexpr (N == 16) {
        return simd::Floats<N>(_mm512_i32gather_ps(index.v, from, 4));
    }
#endif
#if XSIMD_WITH_FMA3_AVX2
    if constexpr (N == 8) {
        return simd::Floats<N>(_mm256_i32gather_ps(from, index.v, 4));
    }
#endif
    alignas(64) std::int32_t at[N];
    alignas(64) float value[N];
    store(at, index);
    for (int i = 0; i < N; ++i) {
        value[i] = from[at[i]];
    }
    return load<Float<N>>(value);
}
template <int N>
Int<N> gather(const std::int32_t* from, Int<N> index) {
#if XSIMD_WITH_AVX512BW
    if constexpr (N == 16) {
        return simd::Ints<N>(_mm512_i32gather_epi32(index.v, from, 4));
    }
#endif
#if XSIMD_WITH_FMA3_AVX2
    if constexpr (N == 8) {
        return simd::Ints<N>(_mm256_i32gather_epi32(from, index.v, 4));
    }
#endif
    alignas(64) std::int32_t at[N];
    alignas(64) std::int32_t value[N];
    store(at, index);
    for (int i = 0; i < N; ++i) {
        value[i] = from[at[i]];
    }
    return load<Int<N>>(value);
}
template <class T>
requires std::is_arithmetic_v<T> T gather(const T* from, std::int32_t index) {
    return from[index];
}

// ---- lanes as bits -------------------------------------------------------------------------

// Bit i is the answer of lane i.
template <int N>
std::uint32_t lane_bits(Mask<N> m) {
#if XSIMD_WITH_AVX512BW
    if constexpr (N == 16) {
        return static_cast<std::uint32_t>(m.v.data);
    }
#endif
#if XSIMD_WITH_FMA3_AVX2
    if constexpr (N == 8) {
        return static_cast<std::uint32_t>(_mm256_movemask_ps(m.v.data));
    }
#endif
#if XSIMD_WITH_SSE2
    if constexpr (N == 4) {
        return static_cast<std::uint32_t>(_mm_movemask_ps(m.v.data));
    }
#endif
    alignas(64) bool answers[N];
    m.v.store_aligned(answers);
    std::uint32_t bits = 0;
    for (int i = 0; i < N; ++i) {
        bits |= static_cast<std::uint32_t>(answers[i]) << i;
    }
    return bits;
}
inline std::uint32_t lane_bits(bool m) {
    return m ? 1U : 0U;
}

// Stores the values of the answering lanes side by side and returns how many there are.
// May write up to N values, whatever it returns.
template <int N>
int store_compressed(std::int32_t* to, Mask<N> m, Int<N> a) {
    std::uint32_t bits = lane_bits(m);
#if XSIMD_WITH_AVX512BW
    if constexpr (N == 16) {
        const auto mask = static_cast<__mmask16>(bits);
        _mm512_storeu_si512(to, _mm512_maskz_compress_epi32(mask, a.v));
        return std::popcount(bits);
    }
#endif
    alignas(64) std::int32_t value[N];
    store(value, a);
    int count = 0;
    for (; bits != 0; bits &= bits - 1) {
        to[count++] = value[std::countr_zero(bits)];
    }
    return count;
}
inline int store_compressed(std::int32_t* to, bool m, std::int32_t a) {
    *to = a;
    return m ? 1 : 0;
}

}  // namespace glint

// GLM asks whether its components are numbers; lanes are.
template <int N>
struct std::numeric_limits<glint::Float<N>> : std::numeric_limits<float> {};
