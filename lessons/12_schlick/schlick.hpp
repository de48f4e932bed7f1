// Lesson 12: Schlick's approximation of Fresnel's reflectance (1994), from F0, the reflectance at
// normal incidence: light that comes along the normal, theta = 0.
//
//     F(theta) = F0 + (1 - F0) (1 - cos(theta))^5
#pragma once

#include "framework/math/pow.hpp"
#include "framework/math/vec.hpp"

namespace glint {

// F0 of a dielectric whose relative index (n2/n1) is ior > 0.
template <Real T>
T f0_dielectric(const T& ior) {
    // SOLUTION 12.1
    const T r = (ior - T(1.0F)) / (ior + T(1.0F));
    return r * r;
    // HANDOUT
    // return min(ior, T(0.04F));  // TODO 12.1: from the index
    // END
}

// F0 of a conductor ior + i k in air. The slides' formula leaves k out, which makes gold 53 % red,
// 16 % green and 3 % blue instead of 96 %, 79 % and 41 %.
template <Real T>
T f0_conductor(const T& ior, const T& k) {
    // SOLUTION 12.2
    const T below = ior - T(1.0F);
    const T above = ior + T(1.0F);
    return (below * below + k * k) / (above * above + k * k);
    // HANDOUT
    // return min(ior + k, T(0.5F));  // TODO 12.2: from the complex index
    // END
}

// (1 - cos)^5: three multiplications. cos_i is clamped to 0..1.
template <Real T>
T schlick_weight(const T& cos_i) {
    // SOLUTION 12.3
    const T m = T(1.0F) - clamp(cos_i, T(0.0F), T(1.0F));
    const T m2 = m * m;
    return m2 * m2 * m;
    // HANDOUT
    // return min(cos_i, T(0.0F));  // TODO 12.3: (1 - cos)^5
    // END
}

// V is a number or a colour.
template <class V, Real T>
V schlick(const V& F0, const T& cos_i) {
    return F0 + (V(T(1.0F)) - F0) * schlick_weight(cos_i);
}

// Lagarde's spherical Gaussian for the same weight (2012): 2^((-5.55473 c - 6.98316) c).
template <class V, Real T>
V schlick_gaussian(const V& F0, const T& cos_i) {
    const T c = clamp(cos_i, T(0.0F), T(1.0F));
    return F0 + (V(T(1.0F)) - F0) * exp2((T(-5.55473) * c - T(6.98316)) * c);
}

// Lazanyi and Szirmay-Kalos (2005): Schlick less a term dip c (1 - c)^6 that follows a metal's dip
// before grazing. lazanyi_dip() meets the exact reflectance at cos = 1/7, where the term peaks.
template <Real T>
T lazanyi_dip(const T& F0, const T& exact_at_a_seventh) {
    const T c = T(1.0F) / T(7.0F);
    return (schlick(F0, c) - exact_at_a_seventh) / (c * schlick_weight(c) * (T(1.0F) - c));
}

template <class V, Real T>
V lazanyi(const V& F0, const V& dip, const T& cos_i) {
    const T c = clamp(cos_i, T(0.0F), T(1.0F));
    return schlick(F0, c) - dip * (c * schlick_weight(c) * (T(1.0F) - c));
}

}  // namespace glint
