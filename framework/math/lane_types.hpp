// The SIMD types: N floats, N 32-bit integers, N answers, with operators that act lane by lane.
#pragma once

#include "framework/math/one_lane.hpp"
#include "framework/math/simd.hpp"

#include <cstdint>
#include <limits>

namespace glint {

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
    friend Mask<N> operator<(Int a, Int b) { return simd::as_bools(a.v < b.v); }
    friend Mask<N> operator>(Int a, Int b) { return simd::as_bools(a.v > b.v); }
    friend Mask<N> operator<=(Int a, Int b) { return simd::as_bools(a.v <= b.v); }
    friend Mask<N> operator>=(Int a, Int b) { return simd::as_bools(a.v >= b.v); }
    friend Mask<N> operator==(Int a, Int b) { return simd::as_bools(a.v == b.v); }
    friend Mask<N> operator!=(Int a, Int b) { return !(a == b); }
    Int& operator+=(Int b) { return *this = *this + b; }
    Int& operator-=(Int b) { return *this = *this - b; }
};

// N floats, IEEE 754 single precision, round to nearest. The sign is the compiler's own: xsimd 8
// says 0 - a, which is 0 for -0.
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
    friend Float operator/(Float a, Float b) { return simd::quotient(a.v, b.v); }
    friend Float operator-(Float a) { return simd::Floats<N>(-a.v.data); }
    friend Mask<N> operator<(Float a, Float b) { return a.v < b.v; }
    friend Mask<N> operator>(Float a, Float b) { return a.v > b.v; }
    friend Mask<N> operator<=(Float a, Float b) { return a.v <= b.v; }
    friend Mask<N> operator>=(Float a, Float b) { return a.v >= b.v; }
    friend Mask<N> operator==(Float a, Float b) { return a.v == b.v; }
    friend Mask<N> operator!=(Float a, Float b) { return !(a == b); }
    Float& operator+=(Float b) { return *this = *this + b; }
    Float& operator-=(Float b) { return *this = *this - b; }
    Float& operator*=(Float b) { return *this = *this * b; }
    Float& operator/=(Float b) { return *this = *this / b; }
};

template <int N>
struct Lanes {
    using Float = glint::Float<N>;
    using Int = glint::Int<N>;
    using Mask = glint::Mask<N>;
};

template <int N>
inline constexpr int lanes_of<Float<N>> = N;
template <int N>
inline constexpr int lanes_of<Int<N>> = N;

template <int N>
inline constexpr bool is_lanes<Float<N>> = true;

}  // namespace glint

// GLM asks whether its components are numbers; lanes are.
template <int N>
struct std::numeric_limits<glint::Float<N>> : std::numeric_limits<float> {};
