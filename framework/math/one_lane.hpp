// What a template on a number type may call, for types of one lane: float, double, std::int32_t and
// bool. lanes.hpp has the same for many, and is to be included only where lanes are: write
// select(mask, a, b), any(mask), all(mask), never if (mask), and one text runs on both.
#pragma once

#include "framework/math/instruction_set.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace glint {

// ---- types ---------------------------------------------------------------------------------

// What belongs together: Lanes<N>::Float, ::Int and ::Mask; plain scalars for one lane.
template <int N>
struct Lanes;
template <>
struct Lanes<1> {
    using Float = float;
    using Int = std::int32_t;
    using Mask = bool;
};

template <class T>
inline constexpr int lanes_of = 1;

template <class T>
inline constexpr bool is_lanes = false;

// The integers and the answers that go with a floating-point type; double is one lane.
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

template <class T>
requires std::is_arithmetic_v<T> T select(bool m, T yes, std::type_identity_t<T> no) {
    return m ? yes : no;
}
inline bool any(bool m) {
    return m;
}
inline bool all(bool m) {
    return m;
}

// ---- min, max, abs, sqrt, fma --------------------------------------------------------------

// min and max return b where a and b are unordered: max(x, 0) turns NaN into 0.
template <class T>
requires std::is_arithmetic_v<T> T min(T a, std::type_identity_t<T> b) {
    return a < b ? a : b;
}
template <class T>
requires std::is_arithmetic_v<T> T max(T a, std::type_identity_t<T> b) {
    return a > b ? a : b;
}

using std::abs;
using std::sqrt;

// 1/sqrt(a) of normal a > 0, to 14 bits or more: what a step of Newton's iteration starts from.
inline float inverse_sqrt_estimate(float a) {
    return simd::inverse_sqrt_estimate(a);
}
inline double inverse_sqrt_estimate(double a) {
    return 1.0 / std::sqrt(a);
}

// a*b + c; of floats rounded once where the processor can, else twice, on one lane as on many.
inline float fma(float a, float b, float c) {
    return simd::fma(a, b, c);
}
inline double fma(double a, double b, double c) {
    return std::fma(a, b, c);
}

// a 2^k, rounded once, for 1/2 <= a < 2 and whole k from -151 to 128.
inline float scale(float a, float k) {
    return simd::scale(a, k);
}

// ---- conversions ---------------------------------------------------------------------------

inline std::int32_t round_to_int(float a) {  // to nearest, ties to even; |a| < 2^31
    return static_cast<std::int32_t>(__builtin_rintf(a));
}
template <class T>
requires std::is_floating_point_v<T> std::int32_t truncate_to_int(
    T a) {  // towards zero; |a| < 2^31
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

// load and store move as many consecutive values as there are lanes; any alignment.
template <class T>
requires std::is_arithmetic_v<T> T load(const T* from) {
    return *from;
}
template <class T>
requires std::is_arithmetic_v<T>
void store(T* to, T a) {
    *to = a;
}

// from[index] for each lane; every index must be in range.
template <class T>
requires std::is_arithmetic_v<T> T gather(const T* from, std::int32_t index) {
    return from[index];
}

// table[index mod 16], much faster than gather where a table fits in registers.
inline float lookup16(const float* table, std::int32_t index) {
    return table[index & 15];
}

template <class T>
requires std::is_floating_point_v<T> T first_lane(T a) {
    return a;
}

}  // namespace glint
