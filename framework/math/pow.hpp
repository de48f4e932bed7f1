// exp2, log2 and pow: one algorithm, the same bits on one lane and on many. For double, which is
// the reference, they are the standard library's.
#pragma once

#include "framework/math/polynomial.hpp"

#include <cmath>
#include <limits>

namespace glint {

// log2(x), off by less than 2 units in the last place for every x, subnormal numbers included.
// log2(+-0) = -inf; NaN for x < 0.
template <Real T>
T log2(T x) {
    if constexpr (std::same_as<T, double>) {
        return std::log2(x);
    } else {
        using I = IntOf<T>;
        constexpr float infinity = std::numeric_limits<float>::infinity();
        // x = 2^e (1 + f), 1/sqrt(2) <= 1 + f < sqrt(2); subnormal x is first made normal.
        const T positive = max(x, T(0.0F));
        const auto subnormal = positive < T(std::numeric_limits<float>::min());
        const I bits = bits_of(select(subnormal, positive * T(0x1p23F), positive));
        const I above = bits - I(bits_of(0.707106781F));
        const T e = to_float(above >> 23) - select(subnormal, T(23.0F), T(0.0F));
        const T f = float_from_bits(bits - (above & I(~0x7fffff))) - T(1.0F);
        // log2(1 + f) / f: a minimax fit of degree 8, relative error 3.8e-8.
        const T p =
            polynomial(f, 1.44269502F, -0.721347332F, 0.480910391F, -0.36070314F, 0.287916243F,
                       -0.238944814F, 0.215721339F, -0.207278982F, 0.125808194F);
        const T nan(std::numeric_limits<float>::quiet_NaN());
        const T special = select(x == T(0.0F), T(-infinity), select(x > T(0.0F), x, nan));
        const MaskOf<T> ordinary = (x > T(0.0F)) & (x < T(infinity));
        return select(ordinary, fma(f, p, e), special);
    }
}

// 2^x, off by less than 2 units in the last place for every x, subnormal results included.
template <Real T>
T exp2(T x) {
    if constexpr (std::same_as<T, double>) {
        return std::exp2(x);
    } else {
        using I = IntOf<T>;
        // x = k + f, |f| <= 1/2: adding 1.5 * 2^23 leaves the integer k in the lowest bits.
        const T shift(0x1.8p23F);
        const T limited = min(max(x, T(-151.0F)), T(128.0F));  // 2^-151 rounds to 0, 2^128 to inf
        const T shifted = limited + shift;
        const T f = limited - (shifted - shift);
        // 2^f: a minimax fit of degree 6, relative error 1.1e-8.
        const T p = polynomial(f, 1.0F, 0.693147182F, 0.240226433F, 0.0555032715F, 0.00961848162F,
                               0.00134031184F, 0.000153639048F);
        // k goes into the exponent; where that is too small for it, in two steps.
        const auto small = limited < T(-125.0F);
        const I k = bits_of(select(small, shifted + T(24.0F), shifted)) << 23;
        const T power = float_from_bits(bits_of(p) + k) * select(small, T(0x1p-24F), T(1.0F));
        return select(x <= T(std::numeric_limits<float>::infinity()), power, x);  // x is NaN
    }
}

// x^n for x >= 0; NaN for x < 0, whatever n (save for double). x^0 = 1^n = 1, even if the other is
// NaN. Relative error of normal results below (1.2 + 1.7 |n log2(x)|) 2^-23.
template <Real T>
T pow(T x, std::type_identity_t<T> n) {
    if constexpr (std::same_as<T, double>) {
        return std::pow(x, n);
    } else {
        const MaskOf<T> one = (x == T(1.0F)) | (n == T(0.0F));
        return exp2(select(one, T(0.0F), n * log2(x)));
    }
}

}  // namespace glint
