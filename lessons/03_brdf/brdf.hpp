// Lesson 3: the BRDF - reflected radiance per irradiance, in 1/sr (Nicodemus et al. 1977).
//
//     BRDF = dL_o / dE_i         dE_i = L_i cos(theta_i) d omega_i
//
// For a directional light of irradiance E (on a surface that faces it) that is, without integral,
//     L_o = BRDF(N, L, V) * E * (N.L)
#pragma once

#include "framework/scene/light.hpp"
#include "framework/raster/shader.hpp"
#include "framework/math/incidence.hpp"
#include "framework/math/pow.hpp"

namespace glint {

// Lambert's BRDF as the slides start with it, without 1/pi: the same in all directions.
inline Rgb<float> lambert_unnormalised(const Rgb<float>& Cd) {
    // SOLUTION 03.1
    return Cd;
    // HANDOUT
    // return Rgb<float>(0.0F);  // TODO 03.1: the BRDF of Lambert's law
    // END
}

// Phong's lobe (V.R)^n, clamped: 0 where V.R <= 0, also for n = 0, so that it tends to the half
// space V.R > 0 as n falls to 0. Unclamped, an even n would show a second highlight opposite to
// the first, an odd n negative light, any other n NaN.
template <Real T>
T phong_lobe(const Incidence<T>& g, const T& n) {
    // SOLUTION 03.2
    const T cosine = clamp(v_dot_r(g), T(0.0F), T(1.0F));  // 0 for what is not a number
    return select(cosine > T(0.0F), pow(cosine, n), T(0.0F));
    // HANDOUT
    // return T(0.0F);  // TODO 03.2: (V.R)^n, clamped
    // END
}

// Radiance that a BRDF value makes of one light. Nothing, the highlight included, is reflected
// where the light is below the horizon.
template <Real T>
Rgb<T> reflect_light(const Rgb<T>& brdf, const Rgb<T>& irradiance, const T& NL) {
    // SOLUTION 03.3
    return brdf * irradiance * max(NL, T(0.0F));
    // HANDOUT
    // return Rgb<T>(T(0.0F));  // TODO 03.3: L_o = BRDF * E * (N.L)
    // END
}

// The slides' Lambert + Phong: Cd + Ks (V.R)^n. Neither reciprocity nor energy is looked at yet.
struct LambertPhong {
    Rgb<float> Cd, Ks;
    float n;

    template <Real T>
    Rgb<T> operator()(const Incidence<T>& g) const {
        return Rgb<T>(lambert_unnormalised(Cd)) + Ks * phong_lobe(g, T(n));
    }
};

}  // namespace glint
