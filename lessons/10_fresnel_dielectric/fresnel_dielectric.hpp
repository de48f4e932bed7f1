// Lesson 10: how much light is reflected at the surface of a dielectric (Fresnel 1823).
//
//     r_par  = (n1 cos2 - n2 cos1) / (n1 cos2 + n2 cos1)
//     r_perp = (n1 cos1 - n2 cos2) / (n1 cos1 + n2 cos2)     R = (r_par^2 + r_perp^2) / 2
//
// with cos2 by Snell's law, n1 sin1 = n2 sin2; beyond the critical angle all light is reflected.
#pragma once

#include "framework/math/vec.hpp"

namespace glint {

// Shares of the light's power, 0..1, by polarisation.
template <Real T>
struct Reflectances {
    T parallel, perpendicular, unpolarised;
};

// Cosine of the refracted ray's angle; -1 where there is none (total internal reflection).
template <Real T>
T refracted_cosine(const T& n1, const T& n2, const T& cos1) {
    // SOLUTION 10.1
    // (n2 cos2)^2 = n2^2 - n1^2 sin1^2, written so that nothing cancels at grazing incidence
    const T along = n1 * cos1;
    const T square = (n2 - n1) * (n2 + n1) + along * along;
    return select(square < T(0.0F), T(-1.0F), sqrt(max(square, T(0.0F))) / n2);
    // HANDOUT
    // return select(n1 > T(0.0F), cos1, n2);  // TODO 10.1: Snell's law
    // END
}

// n1, n2 > 0: refractive indices on the light's and on the other side; cos1 = 0..1, clamped.
// Equal indices reflect nothing, at grazing incidence too, where the formula is 0/0.
template <Real T>
Reflectances<T> fresnel_dielectric(const T& n1, const T& n2, const T& cos_i) {
    const T cos1 = clamp(cos_i, T(0.0F), T(1.0F));
    const T cos2 = refracted_cosine(n1, n2, cos1);
    const T zero(0.0F);
    const T one(1.0F);
    // SOLUTION 10.2
    const T r_par = (n1 * cos2 - n2 * cos1) / (n1 * cos2 + n2 * cos1);
    const T r_perp = (n1 * cos1 - n2 * cos2) / (n1 * cos1 + n2 * cos2);
    const T par = r_par * r_par;
    const T perp = r_perp * r_perp;
    // HANDOUT
    // const T par = zero;  // TODO 10.2: r_par^2 and r_perp^2
    // const T perp = zero;
    // END
    const auto same = n1 == n2;
    const auto total = cos2 < zero;
    const T R_par = select(same, zero, select(total, one, par));
    const T R_perp = select(same, zero, select(total, one, perp));
    return {R_par, R_perp, T(0.5F) * (R_par + R_perp)};
}

}  // namespace glint
