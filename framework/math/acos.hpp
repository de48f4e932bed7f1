// The angle whose cosine is given: one algorithm, the same bits on one lane and on many. For
// double, which is the reference, it is the standard library's.
#pragma once

#include "framework/math/polynomial.hpp"

#include <cmath>
#include <numbers>

namespace glint {

// In radians, 0..pi, off by less than 5e-7; x is limited to -1..1, and NaN counts as -1.
template <Real T>
T acos(T x) {
    const T cosine = clamp(x, T(-1.0F), T(1.0F));
    if constexpr (std::same_as<T, double>) {
        return std::acos(cosine);
    } else {
        // acos(c) / sqrt(1 - c) on 0..1: Abramowitz and Stegun 4.4.46, off by 2e-8.
        const T c = abs(cosine);
        const T p = polynomial(c, 1.5707963050F, -0.2145988016F, 0.0889789874F, -0.0501743046F,
                               0.0308918810F, -0.0170881256F, 0.0066700901F, -0.0012624911F);
        const T angle = sqrt(T(1.0F) - c) * p;
        return select(cosine < T(0.0F), T(std::numbers::pi_v<float>) - angle, angle);
    }
}

}  // namespace glint
