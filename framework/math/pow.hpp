// exp2, log2 and pow: one algorithm, the same bits on one lane and on many. For double, which is
// the reference, they are the standard library's.
#pragma once

#include "framework/math/polynomial.hpp"

#include <cmath>
#include <limits>

namespace glint {

namespace pow_detail {

inline constexpr float smallest_normal = std::numeric_limits<float>::min();
inline constexpr float infinity = std::numeric_limits<float>::infinity();

// log2(x) of normal x > 0.
template <class T>
T log2_of_normal(T x) {
    using I = IntOf<T>;
    // x = 2^e (1 + f), 1/sqrt(2) <= 1 + f < sqrt(2)
    const I bits = bits_of(x);
    const I above = bits - I(bits_of(0.707106781F));
    const T e = to_float(above >> 23);
    const T f = float_from_bits(bits - (above & I(~0x7fffff))) - T(1.0F);
    // log2(1 + f) / f: a minimax fit of degree 8, relative error 3.8e-8.
    const T p = polynomial(f, 1.44269502F, -0.721347332F, 0.480910391F, -0.36070314F, 0.287916243F,
                           -0.238944814F, 0.215721339F, -0.207278982F, 0.125808194F);
    return fma(f, p, e);
}

// 2^x; 0 for NaN.
template <class T>
T exp2_of_number(T x) {
    // x = k + f, |f| <= 1/2: adding 1.5 * 2^23 rounds to a whole number.
    const T shift(0x1.8p23F);
    const T limited = min(max(x, T(-151.0F)), T(128.0F));  // 2^-151 rounds to 0, 2^128 to inf
    const T k = (limited + shift) - shift;
    const T f = limited - k;
    // 2^f: a minimax fit of degree 6, relative error 1.1e-8.
    return scale(polynomial(f, 1.0F, 0.693147182F, 0.240226433F, 0.0555032715F, 0.00961848162F,
                            0.00134031184F, 0.000153639048F),
                 k);
}

}  // namespace pow_detail

// log2(x), off by less than 2 units in the last place for every x, subnormal numbers included.
// log2(+-0) = -inf; NaN for x < 0.
template <Real T>
T log2(T x) {
    if constexpr (std::same_as<T, double>) {
        return std::log2(x);
    } else {
        using namespace pow_detail;
        const auto subnormal = x < T(smallest_normal);
        const T normal = max(select(subnormal, x * T(0x1p23F), x), T(smallest_normal));
        const T y = log2_of_normal(normal) - select(subnormal, T(23.0F), T(0.0F));
        const T nan(std::numeric_limits<float>::quiet_NaN());
        const T special = select(x == T(0.0F), T(-infinity), select(x > T(0.0F), x, nan));
        return select((x > T(0.0F)) & (x < T(infinity)), y, special);
    }
}

// 2^x, off by less than 2 units in the last place for every x, subnormal results included.
template <Real T>
T exp2(T x) {
    if constexpr (std::same_as<T, double>) {
        return std::exp2(x);
    } else {
        return select(x <= T(pow_detail::infinity), pow_detail::exp2_of_number(x), x);  // x is NaN
    }
}

namespace pow_detail {

template <class T>
[[gnu::noinline]] T pow_anywhere(T x, T n) {
    const MaskOf<T> one = (x == T(1.0F)) | (n == T(0.0F));
    return exp2(select(one, T(0.0F), n * log2(x)));
}

// By squaring: x^50 = x^32 x^16 x^2.
template <class T>
T pow_whole(T x, std::uint32_t n) {
    T power(1.0F);
    for (; n > 1; n >>= 1) {
        if ((n & 1) != 0) {
            power *= x;
        }
        x *= x;
    }
    return n == 0 ? power : power * x;
}
inline constexpr float largest_whole = 64;

}  // namespace pow_detail

// x^n for x >= 0; x^0 = 1^n = 1, even if the other is NaN.
//
// A whole exponent up to 64, the same in all lanes, is reached by squaring, for any x; relative
// error of normal results below n 2^-24, no more than if x were off by half a unit in its last
// place. Any other: NaN for x < 0; error below (1.2 + 1.7 |n log2(x)|) 2^-23; quickest where all
// lanes are normal numbers, neither zero nor subnormal, infinite or NaN.
template <Real T>
T pow(T x, std::type_identity_t<T> n) {
    if constexpr (std::same_as<T, double>) {
        return std::pow(x, n);
    } else {
        using namespace pow_detail;
        const float m = first_lane(n);
        if (m >= 0.0F && m <= largest_whole && m == std::floor(m) && all(n == T(m))) {
            return pow_whole(x, static_cast<std::uint32_t>(m));
        }
        if (all((x >= T(smallest_normal)) & (x < T(infinity)) & (abs(n) < T(infinity))))
            [[likely]] {
            return exp2_of_number(n * log2_of_normal(x));
        }
        return pow_anywhere(x, n);
    }
}

}  // namespace glint
