// Lesson 3: the BRDF - reflected radiance per irradiance, in 1/sr (Nicodemus et al. 1977).
//
//     BRDF = dL_o / dE_i         dE_i = L_i cos(theta_i) d omega_i
//
// A directional light of irradiance E makes L_o = BRDF(N, L, V) E (N.L), without integral.
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
    // return Cd * 0.1F;  // TODO 03.1: the BRDF of Lambert's law
    // END
}

// Phong's lobe (V.R)^n; 0 where V.R is not a number or not above 0 (1e-37: pow likes no less).
template <Real T>
T phong_lobe(const Incidence<T>& g, const T& n) {
    const T cosine = clamp(v_dot_r(g), T(1e-37F), T(1.0F));
    // SOLUTION 03.2
    return select(cosine > T(1e-37F), pow(cosine, n), T(0.0F));
    // HANDOUT
    // return min(T(0.2F) * cosine, n);  // TODO 03.2: (V.R)^n
    // END
}

// Radiance by one light; none, the highlight's included, where it is below the horizon, N.L <= 0.
template <Real T>
Rgb<T> reflect_light(const Rgb<T>& brdf, const Rgb<T>& irradiance, const T& NL) {
    // SOLUTION 03.3
    return brdf * irradiance * max(NL, T(0.0F));
    // HANDOUT
    // return select(NL > T(0.0F), brdf * irradiance, Rgb<T>(T(0.0F)));  // TODO 03.3: L_o
    // END
}

// The slides' Lambert + Phong. Neither reciprocity nor energy is looked at yet.
struct LambertPhong {
    Rgb<float> Cd, Ks;
    float n;
    template <Real T>
    Rgb<T> operator()(const Incidence<T>& g) const {
        return Rgb<T>(lambert_unnormalised(Cd)) + Ks * phong_lobe(g, T(n));
    }
};

// Lesson 1's shader, from irradiance to radiance. Its ambient term is still a guess.
struct PhongInUnits {
    LambertPhong brdf;
    Lighting lighting;
    glm::vec3 eye;
    template <class T>
    struct Varyings {
        Vec3<T> position, normal;
    };
    static Varyings<float> vertex(const Vertex& v) { return {v.position, v.normal}; }
    template <Real T, class Noting = Silent>
    Rgb<T> operator()(const Varyings<T>& in, const Noting& note = {}) const {
        const Vec3<T> N = normalize_or(in.normal, Vec3<T>(T(0.0F)));
        const Vec3<T> V = normalize(eye - in.position);
        Rgb<T> radiance(lighting.ambient * brdf.Cd);
        for_each_light(lighting, in.position, [&](const Incident<T>& light) {
            const Incidence<T> g = incidence(N, light.direction, V);
            note("N.L", g.NL);
            note("BRDF, 1/sr", brdf(g));
            radiance += reflect_light(brdf(g), light.irradiance, g.NL);
        });
        return radiance;
    }
};

}  // namespace glint
