// Every width that a text runs at, and single lanes of it to compare with a scalar.
#pragma once

#include "framework/math/lanes.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace glint {

// Where this build lacks a width, the widest that it has.
using Float4 = Float<4>;
using Float8 = Float<std::min(8, max_lanes)>;
using Float16 = Float<std::min(16, max_lanes)>;

// For TEST_CASE_TEMPLATE: the widths that this build has, each once.
#if XSIMD_WITH_AVX512BW
#define ALL_LANES Float4, Float8, Float16
#elif XSIMD_WITH_FMA3_AVX2
#define ALL_LANES Float4, Float8
#else
#define ALL_LANES Float4
#endif

inline constexpr float infinity = std::numeric_limits<float>::infinity();
inline constexpr float nan = std::numeric_limits<float>::quiet_NaN();

// Lane i of floats, integers and answers.
template <class T>
requires std::is_arithmetic_v<T> T lane(T a, int) {
    return a;
}
template <int N>
float lane(Float<N> a, int i) {
    float lanes[N];
    store(lanes, a);
    return lanes[i];
}
template <int N>
std::int32_t lane(Int<N> a, int i) {
    std::int32_t lanes[N];
    store(lanes, a);
    return lanes[i];
}
template <int N>
bool lane(Mask<N> a, int i) {
    return (lane_bits(a) >> i & 1U) != 0;
}

// Equal bits, or both NaN.
inline bool same(float a, float b) {
    return (std::isnan(a) && std::isnan(b)) || bits_of(a) == bits_of(b);
}
inline bool same(std::int32_t a, std::int32_t b) {
    return a == b;
}
inline bool same(bool a, bool b) {
    return a == b;
}

}  // namespace glint
