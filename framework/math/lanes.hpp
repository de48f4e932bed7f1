// Lanes in memory and as bits. Every function has a twin for one lane, here or in one_lane.hpp.
#pragma once

#include "framework/math/lane_math.hpp"

#include <array>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace glint {

// ---- memory --------------------------------------------------------------------------------

template <class T>
requires is_lanes<T> T load(const float* from) {
    return simd::Floats<lanes_of<T>>::load_unaligned(from);
}
template <class T>
requires std::same_as<T, Int<lanes_of<T>>> T load(const std::int32_t* from) {
    return simd::Ints<lanes_of<T>>::load_unaligned(from);
}
template <int N>
void store(float* to, Float<N> a) {
    a.v.store_unaligned(to);
}
template <int N>
void store(std::int32_t* to, Int<N> a) {
    a.v.store_unaligned(to);
}

// Four numbers from here on, four from a stride on, and so on; of one lane, one number.
template <class T>
requires std::same_as<T, Int<lanes_of<T>>> T load_fours(const std::int32_t* from,
                                                        std::ptrdiff_t stride) {
    return simd::load_fours<simd::Ints<lanes_of<T>>>(from, stride);
}
template <class T>
requires std::same_as<T, std::int32_t> T load_fours(const T* from, std::ptrdiff_t) {
    return *from;
}

// Past the caches, for what is not read soon. to: aligned to the size of a. Other threads may read
// it after finish_streaming() in this one.
template <int N>
void store_streaming(std::int32_t* to, Int<N> a) {
    simd::store_streaming(to, a.v);
}
inline void store_streaming(std::int32_t* to, std::int32_t a) {
    *to = a;
}
using simd::finish_streaming;

// 0, 1, 2, ... one number a lane.
template <class T>
T iota() {
    if constexpr (std::is_arithmetic_v<T>) {
        return T{0};
    } else if constexpr (is_lanes<T>) {
        return to_float(iota<Int<lanes_of<T>>>());
    } else {
        alignas(64) static constexpr std::int32_t numbers[] = {0, 1, 2,  3,  4,  5,  6,  7,
                                                               8, 9, 10, 11, 12, 13, 14, 15};
        return load<T>(numbers);
    }
}

template <int N>
Float<N> gather(const float* from, Int<N> index) {
    return simd::gather(from, index.v);
}
template <int N>
Int<N> gather(const std::int32_t* from, Int<N> index) {
    return simd::gather(from, index.v);
}

template <int N>
Float<N> lookup16(const float* table, Int<N> index) {
    return simd::lookup16(table, index.v);
}

// low[index] or, from N on, high[index - N], index mod 2 N: tables of as many numbers as there are
// lanes; one instruction.
template <int N>
Float<N> lookup(const float* low, const float* high, Int<N> index) {
    return simd::lookup(low, high, index.v);
}
inline float lookup(const float* low, const float* high, std::int32_t index) {
    return (index & 1) == 0 ? *low : *high;
}

template <int N>
float first_lane(Float<N> a) {
    return a.v.get(0);
}

// Four numbers from each of N places: column k holds row[i][k] in lane i. Much faster than four
// gathers; the bits may be those of ints.
template <class T>
using Rows = std::array<T, 4>;
template <class T>
requires is_lanes<T> Rows<T> load_rows(const float* const* row) {
    const auto columns = simd::load_rows<simd::Floats<lanes_of<T>>>(row);
    return {columns[0], columns[1], columns[2], columns[3]};
}
template <class T>
requires std::same_as<T, float> Rows<T> load_rows(const float* const* row) {
    Rows<T> columns;
    std::memcpy(columns.data(), *row, sizeof columns);
    return columns;
}
// And back: row i goes to to[4 i] and on.
template <int N>
void store_rows(float* to, const Rows<Float<N>>& columns) {
    simd::store_rows<simd::Floats<N>>(to, {columns[0].v, columns[1].v, columns[2].v, columns[3].v});
}
inline void store_rows(float* to, const Rows<float>& columns) {
    std::memcpy(to, columns.data(), sizeof columns);
}

// ---- lanes as bits -------------------------------------------------------------------------

// Bit i is the answer of lane i.
template <int N>
std::uint32_t lane_bits(Mask<N> m) {
    return simd::lane_bits(m.v);
}
inline std::uint32_t lane_bits(bool m) {
    return m ? 1U : 0U;
}

// Stores the values of the answering lanes side by side and returns how many there are.
// May write up to N values, whatever it returns.
template <int N>
int store_compressed(std::int32_t* to, Mask<N> m, Int<N> a) {
    return simd::store_compressed(to, lane_bits(m), a.v);
}
inline int store_compressed(std::int32_t* to, bool m, std::int32_t a) {
    *to = a;
    return m ? 1 : 0;
}

// The same of the lanes whose bits are set, none beyond the width.
template <int N>
int store_lanes(std::int32_t* to, std::uint32_t lanes, Int<N> a) {
    return simd::store_compressed(to, lanes, a.v);
}
inline int store_lanes(std::int32_t* to, std::uint32_t lanes, std::int32_t a) {
    return store_compressed(to, lanes != 0, a);
}

}  // namespace glint
