// Lesson 11: reflection at a metal, whose refractive index is complex, ior + i k.
//
// Lesson 10's formulas hold with n2 = ior + i k and n1 = 1; a share of power is |r|^2. With
//     a + i b = n2 cos2 = sqrt((ior + i k)^2 - s^2),   c = cos(theta),  s = sin(theta):
//     R_perp = ((a - c)^2 + b^2) / ((a + c)^2 + b^2)                     (Born and Wolf, 14.2)
//     R_par  = R_perp ((a c - s^2)^2 + (b c)^2) / ((a c + s^2)^2 + (b c)^2)
#pragma once

#include "lessons/10_fresnel_dielectric/fresnel_dielectric.hpp"

namespace glint {

// Exact. ior > 0 and k >= 0, relative to air, up to 1e9; cos_i = 0..1, clamped. k = 0 is a
// dielectric seen from air. Sums of squares: they stay within 0..1 whatever the rounding.
template <Real T>
Reflectances<T> fresnel_conductor(const T& ior, const T& k, const T& cos_i) {
    const T c = clamp(cos_i, T(0.0F), T(1.0F));
    // SOLUTION 11.1
    const T s2 = (T(1.0F) - c) * (T(1.0F) + c);
    const T n = max(ior, T(1e-18F));                           // the square of less may be 0
    const T grazing = (n - T(1.0F)) * (n + T(1.0F)) + c * c;   // n^2 - s^2, and so is:
    const T steep = n * n - s2;                                // each cancels where not used
    const T q = select(s2 > T(0.5F), grazing, steep) - k * k;  // a^2 - b^2
    const T ab = n * k;
    // The greater of a^2 and b^2 without a difference, the smaller from their product.
    const T greater = T(0.5F) * (abs(q) + sqrt(q * q + T(4.0F) * ab * ab));
    const T smaller = ab * (ab / max(greater, T(1e-30F)));
    const T a = sqrt(select(q > T(0.0F), greater, smaller));
    const T b2 = select(q > T(0.0F), smaller, greater);
    const auto square = [](const T& x) { return x * x; };
    const T air = T(1e-30F);  // air in air at grazing incidence is 0/0: it reflects nothing
    const T perp = (square(a - c) + b2) / max(square(a + c) + b2, air);
    const T par = perp * (square(a * c - s2) + b2 * c * c) / (square(a * c + s2) + b2 * c * c);
    // HANDOUT
    // const T perp = T(1.0F) - min(c, ior + k);  // TODO 11.1: R_perp and R_par
    // const T par = perp;
    // END
    return {par, perp, T(0.5F) * (par + perp)};
}

// The approximation that the slides mean: cos2 = 1, as light turns almost along the normal where
// |n2|^2 = ior^2 + k^2 >> 1. Good for metals, useless for glass. With q = ior^2 + k^2
//     R_par  = (q c^2 - 2 ior c + 1) / (q c^2 + 2 ior c + 1)
//     R_perp = (q - 2 ior c + c^2)   / (q + 2 ior c + c^2)         which are, as sums of squares:
template <Real T>
Reflectances<T> fresnel_conductor_approximate(const T& ior, const T& k, const T& cos_i) {
    const T c = clamp(cos_i, T(0.0F), T(1.0F));
    const auto square = [](const T& x) { return x * x; };
    // SOLUTION 11.2
    const T par =
        (square(ior * c - T(1.0F)) + square(k * c)) / (square(ior * c + T(1.0F)) + square(k * c));
    const T perp = (square(ior - c) + square(k)) / (square(ior + c) + square(k));
    // HANDOUT
    // const T perp = T(1.0F) - square(min(c, ior + k));  // TODO 11.2: R_perp and R_par
    // const T par = perp;
    // END
    return {par, perp, T(0.5F) * (par + perp)};
}

}  // namespace glint
