// What any register can do, by xsimd alone. Where the instruction set has something better,
// simd.hpp says so.
#pragma once

#include "framework/math/instruction_set.hpp"

#include <xsimd/xsimd.hpp>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace glint::simd {

// Answers about integers as answers about floats.
template <class A>
xsimd::batch_bool<float, A> as_bools(xsimd::batch_bool<std::int32_t, A> m) {
    return std::bit_cast<xsimd::batch_bool<float, A>>(m);
}

// The compiler's own: xsimd 8 approximates a / b on NEON.
template <class A>
xsimd::batch<float, A> quotient(xsimd::batch<float, A> a, xsimd::batch<float, A> b) {
    return a.data / b.data;
}
inline float quotient(float a, float b) {
    return a / b;
}
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

// a 2^k rounded once, for 1/2 <= a < 2 and whole k from -151 to 128.
template <class F>
F scale(F a, F k) {
    // k goes into the exponent of a; where that would be too small for it, in two steps.
    const F step = xsimd::select(k < F(-125.0F), F(24.0F), F(0.0F));
    const auto exponent = xsimd::batch_cast<std::int32_t>(k + step) << 23;
    const auto bits = std::bit_cast<decltype(exponent)>(a) + exponent;
    return std::bit_cast<F>(bits) * xsimd::select(k < F(-125.0F), F(0x1p-24F), F(1.0F));
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
xsimd::batch<float, typename I::arch_type> lookup(const float* low, const float* high, I index) {
    const I lane = index & I(static_cast<int>(I::size) - 1);
    const auto is_low = as_bools((index & I(static_cast<int>(I::size))) == I(0));
    return xsimd::select(is_low, gather(low, lane), gather(high, lane));
}

// Four floats from each of N places as four registers, and back to N places side by side.
template <class F>
using Rows = std::array<F, 4>;
template <class F>
Rows<F> load_rows(const float* const* row) {
    Rows<F> columns;
    alignas(64) float column[F::size];
    for (std::size_t k = 0; k < 4; ++k) {
        for (std::size_t i = 0; i < F::size; ++i) {
            std::memcpy(&column[i], row[i] + k, sizeof(float));
        }
        columns[k] = F::load_aligned(column);
    }
    return columns;
}
template <class F>
void store_rows(float* to, const Rows<F>& columns) {
    alignas(64) float column[F::size];
    for (std::size_t k = 0; k < 4; ++k) {
        columns[k].store_aligned(column);
        for (std::size_t i = 0; i < F::size; ++i) {
            std::memcpy(to + 4 * i + k, &column[i], sizeof(float));
        }
    }
}

// Four numbers from here on, four from a stride on, and so on.
template <class I>
I load_fours(const std::int32_t* from, std::ptrdiff_t stride) {
    alignas(64) std::int32_t value[I::size];
    for (std::size_t i = 0; i < I::size; i += 4, from += stride) {
        std::memcpy(&value[i], from, 4 * sizeof(std::int32_t));
    }
    return I::load_aligned(value);
}

template <class I>
void store_streaming(std::int32_t* to, I a) {
    a.store_unaligned(to);
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

}  // namespace glint::simd
