// Angles by their cosines and sines: one algorithm, the same bits on one lane and on many. For
// double, which is the reference, it is the standard library's.
#pragma once

#include "framework/math/polynomial.hpp"

#include <cmath>

namespace glint {

// The angle, 0..pi/2 in radians, of this cosine and this sine squared, off by less than 5e-7 of
// itself. Near 0 a cosine hardly tells it: all below 0.014 degrees have 1 in float. Both are
// limited to 0..1, and NaN counts as 0.
template <Real T>
T acute_angle(T cosine, T sin2) {
    const T c = clamp(cosine, T(0.0F), T(1.0F));
    const T s2 = clamp(sin2, T(0.0F), T(1.0F));
    if constexpr (std::same_as<T, double>) {
        return std::atan2(std::sqrt(s2), c);
    } else {
        // acos(c) / sqrt(1 - c), where 1 - c = s2 / (1 + c): Abramowitz and Stegun 4.4.46.
        const T p = polynomial(c, 1.5707963050F, -0.2145988016F, 0.0889789874F, -0.0501743046F,
                               0.0308918810F, -0.0170881256F, 0.0066700901F, -0.0012624911F);
        return sqrt(s2 / (T(1.0F) + c)) * p;
    }
}

}  // namespace glint
