// What is computed lane by lane beyond operators: the functions of one_lane.hpp, which says of each
// what it does.
#pragma once

#include "framework/math/lane_types.hpp"
#include "framework/math/simd_precision.hpp"

#include <bit>
#include <cstdint>
#include <type_traits>

namespace glint {

// ---- select, any, all ----------------------------------------------------------------------

template <int N>
Float<N> select(Mask<N> m, Float<N> yes, Float<N> no) {
    return xsimd::select(m.v, yes.v, no.v);
}
template <int N>
Float<N> select(Mask<N> m, std::type_identity_t<Float<N>> yes, float no) {
    return select(m, yes, Float<N>(no));
}
template <int N>
Float<N> select(Mask<N> m, float yes, std::type_identity_t<Float<N>> no) {
    return select(m, Float<N>(yes), no);
}
template <int N>
Float<N> select(Mask<N> m, float yes, float no) {
    return select(m, Float<N>(yes), Float<N>(no));
}
template <int N>
Int<N> select(Mask<N> m, Int<N> yes, std::type_identity_t<Int<N>> no) {
    return bits_of(select(m, float_from_bits(yes), float_from_bits(no)));
}

template <int N>
bool any(Mask<N> m) {
    return xsimd::any(m.v);
}
template <int N>
bool all(Mask<N> m) {
    return xsimd::all(m.v);
}

// ---- min, max, abs, sqrt, fma --------------------------------------------------------------

template <int N>
Float<N> min(Float<N> a, std::type_identity_t<Float<N>> b) {
    return simd::min(a.v, b.v);
}
template <int N>
Float<N> max(Float<N> a, std::type_identity_t<Float<N>> b) {
    return simd::max(a.v, b.v);
}
template <int N>
Int<N> min(Int<N> a, std::type_identity_t<Int<N>> b) {
    return xsimd::min(a.v, b.v);
}
template <int N>
Int<N> max(Int<N> a, std::type_identity_t<Int<N>> b) {
    return xsimd::max(a.v, b.v);
}
template <int N>
Float<N> sqrt(Float<N> a) {
    return simd::sqrt(a.v);
}
template <int N>
Float<N> abs(Float<N> a) {
    return xsimd::abs(a.v);
}
template <int N>
Float<N> inverse_sqrt_estimate(Float<N> a) {
    return simd::inverse_sqrt_estimate(a.v);
}
template <int N>
Float<N> fma(Float<N> a, std::type_identity_t<Float<N>> b, std::type_identity_t<Float<N>> c) {
    return simd::fma(a.v, b.v, c.v);
}
template <int N>
Float<N> scale(Float<N> a, Float<N> k) {
    return simd::scale(a.v, k.v);
}

// ---- what is asked for beside lanes only, so for one lane, too ------------------------------

// 1/a of 2^-126 <= |a| <= 2^126: off by less than 2 units in the last place. Some processors give
// NaN where a is 0 or infinite.
template <int N>
Float<N> reciprocal(Float<N> a) {
    return simd::reciprocal(a.v);
}
inline float reciprocal(float a) {
    return simd::reciprocal(a);
}

// a b - c d, off by less than 2 units in its last place even where it cancels.
template <int N>
Float<N> difference_of_products(Float<N> a, Float<N> b, Float<N> c, Float<N> d) {
    return simd::difference_of_products(a.v, b.v, c.v, d.v);
}
inline float difference_of_products(float a, float b, float c, float d) {
    return simd::difference_of_products(a, b, c, d);
}

// ---- conversions ---------------------------------------------------------------------------

template <int N>
Int<N> round_to_int(Float<N> a) {
    return xsimd::nearbyint_as_int(a.v);
}
template <int N>
Int<N> truncate_to_int(Float<N> a) {
    return xsimd::batch_cast<std::int32_t>(a.v);
}
template <int N>
Float<N> to_float(Int<N> a) {
    return Float<N>(a);
}
template <int N>
Int<N> bits_of(Float<N> a) {
    return std::bit_cast<simd::Ints<N>>(a.v);
}
template <int N>
Float<N> float_from_bits(Int<N> a) {
    return std::bit_cast<simd::Floats<N>>(a.v);
}

// ---- subnormal numbers ---------------------------------------------------------------------

// While it lives, numbers below 2^-126 count as 0 in this thread. They are darker than anything
// that is seen, and slow: a highlight that fades away took half as long again.
class FlushSubnormals {
  public:
    FlushSubnormals() { simd::set_control_word(saved_ | simd::flush_to_zero); }
    ~FlushSubnormals() { simd::set_control_word(saved_); }
    FlushSubnormals(const FlushSubnormals&) = delete;
    FlushSubnormals& operator=(const FlushSubnormals&) = delete;

  private:
    std::uint64_t saved_ = simd::control_word();
};

}  // namespace glint
