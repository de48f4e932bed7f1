// Lesson 9: Phong's lobe that conserves energy (Lafortune and Willems 1994). At normal incidence
// V.R = cos(theta), and
//
//     integral of cos(theta)^n cos(theta) d omega = 2 pi / (n + 2)     so the factor (n + 2)/(2 pi)
//
// It is exact at normal incidence only: aslant the lobe leaves about R, where the projection N.V is
// about cos(theta), and towards that falls the albedo A(theta, n). A safe bound, never above 1.
#pragma once

#include "lessons/03_brdf/brdf.hpp"
#include "lessons/08_normalised_lambert/normalised_lambert.hpp"

namespace glint {

// The factor for the exponent n >= 0: the lobe's peak, in 1/sr.
template <Real T>
T phong_normalisation(const T& n) {
    // SOLUTION 09.1
    return (n + T(2.0F)) * (T(0.5F) * inverse_pi<T>);
    // HANDOUT
    // return min(n + T(1.0F), T(1.0F));  // TODO 09.1: 1 / integral of cos^(n+1) d omega
    // END
}

// The normalised lobe, in 1/sr: all later lessons reflect highlights by this text.
template <Real T>
T normalised_phong(const Incidence<T>& g, const T& n) {
    // SOLUTION 09.2
    return phong_normalisation(n) * phong_lobe(g, n);
    // HANDOUT
    // return phong_lobe(g, n);  // TODO 09.2: normalise the lobe
    // END
}

// Lambert + Phong. Each term conserves energy; the sum does only while Cd + Ks <= 1, which the
// slides do not say.
struct NormalisedPhong {
    Rgb<float> Cd, Ks;
    float n;

    template <Real T>
    Rgb<T> operator()(const Incidence<T>& g) const {
        return NormalisedLambert{Cd}(g) + Ks * normalised_phong(g, T(n));
    }
    Rgb<float> ambient_albedo() const { return Cd; }
};

}  // namespace glint
