// Lesson 11: reflection at a metal, whose refractive index is complex, ior + i k.
#pragma once

#include "lessons/10_fresnel_dielectric/fresnel_dielectric.hpp"

namespace glint {

// Exact (Born and Wolf, Principles of Optics, 14.2; as in PBRT). With q = ior^2 - k^2 - sin^2:
//     a^2 + b^2 = sqrt(q^2 + 4 ior^2 k^2),  2 a^2 = (a^2 + b^2) + q
//     R_perp = ((a^2+b^2) + c^2 - 2 a c) / ((a^2+b^2) + c^2 + 2 a c)
//     R_par  = R_perp * (c^2 (a^2+b^2) + s^4 - 2 a c s^2) / (c^2 (a^2+b^2) + s^4 + 2 a c s^2)
// ior > 0, k >= 0, relative to air; cos_i = 0..1, clamped. k = 0 is a dielectric seen from air.
template <Real T>
Reflectances<T> fresnel_conductor(const T& ior, const T& k, const T& cos_i) {
    const T c = clamp(cos_i, T(0.0F), T(1.0F));
    const T s2 = (T(1.0F) - c) * (T(1.0F) + c);
    // SOLUTION 11.1
    const T q = (ior - k) * (ior + k) - s2;
    const T p = T(2.0F) * ior * k;
    const T sum = sqrt(q * q + p * p);  // a^2 + b^2
    // 2 a^2 = sum + q cancels where q is negative; p^2 / (sum - q) is the same and does not.
    const T twice = select(q > T(0.0F), sum + q, p * p / max(sum - q, T(1e-30F)));
    const T a = sqrt(max(T(0.5F) * twice, T(0.0F)));
    const T ac = T(2.0F) * a * c;
    const T perp = (sum + c * c - ac) / max(sum + c * c + ac, T(1e-30F));  // air in air: 0
    const T par = perp * (c * c * sum + s2 * s2 - ac * s2) / (c * c * sum + s2 * s2 + ac * s2);
    // HANDOUT
    // const T perp = T(0.0F);  // TODO 11.1: R_perp and R_par
    // const T par = T(0.0F);
    // END
    return {par, perp, T(0.5F) * (par + perp)};
}

// The approximation that the slides mean, for ior^2 + k^2 >> 1 (metals; useless for glass). What
// they print is garbled: "cos * 2" was cos^2, and the perpendicular form gained a factor.
//     R_par  = (q c^2 - 2 ior c + 1) / (q c^2 + 2 ior c + 1)         q = ior^2 + k^2
//     R_perp = (q - 2 ior c + c^2)   / (q + 2 ior c + c^2)
template <Real T>
Reflectances<T> fresnel_conductor_approximate(const T& ior, const T& k, const T& cos_i) {
    const T c = clamp(cos_i, T(0.0F), T(1.0F));
    // SOLUTION 11.2
    const T q = ior * ior + k * k;
    const T twice = T(2.0F) * ior * c;
    const T par = (q * c * c - twice + T(1.0F)) / (q * c * c + twice + T(1.0F));
    const T perp = (q - twice + c * c) / (q + twice + c * c);
    // HANDOUT
    // const T perp = T(0.0F);  // TODO 11.2: the approximate R_perp and R_par
    // const T par = T(0.0F);
    // END
    return {par, perp, T(0.5F) * (par + perp)};
}

}  // namespace glint
