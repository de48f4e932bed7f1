// Lesson 4: the rendering equation (Kajiya 1986), for surfaces that do not glow:
//
//     L_o(V) = integral over the hemisphere of BRDF(L, V) L_i(L) (N.L) d omega
//
// As a sum: a piece d omega of the sky is a lamp of irradiance E = L_i d omega. And what comes from
// all directions alike, La, leaves the integral: L_o = La albedo, the "ambient term" derived.
#pragma once

#include "lessons/03_brdf/brdf.hpp"

#include <numbers>

namespace glint {

// A BRDF is a functor: Rgb<T> operator()(const Incidence<T>&) const, in 1/sr, for N.L > 0, and
// Rgb<float> ambient_albedo() const, the share of constant light from everywhere that it reflects.
// Lit is the fragment shader of all later lessons.
template <class Brdf>
struct Lit {
    Brdf brdf;
    Lighting lighting;
    glm::vec3 eye;

    template <class T>
    struct Varyings {
        Vec3<T> position, normal;
    };
    static Varyings<float> vertex(const Vertex& v) { return {v.position, v.normal}; }

    // A normal of length zero reflects ambient light only; one that looks away is taken as it is.
    template <Real T, class Noting = Silent>
    Rgb<T> operator()(const Varyings<T>& in, const Noting& note = {}) const {
        const Vec3<T> V = normalize(eye - in.position);
        const Vec3<T> N = normalize_or(in.normal, Vec3<T>(T(0.0F)));
        Rgb<T> radiance(lighting.ambient * brdf.ambient_albedo());
        note("ambient", radiance);
        for_each_light(lighting, in.position, [&](const Incident<T>& light) {
            const Incidence<T> g = incidence(N, light.direction, V);
            const Rgb<T> f = brdf(g);
            note("N.L", g.NL);
            note("V.R", v_dot_r(g));
            note("BRDF", f);
            // SOLUTION 04.1
            radiance += reflect_light(f, light.irradiance, g.NL);
            // HANDOUT
            // radiance = reflect_light(f, light.irradiance, g.NL);  // TODO 04.1: the sum
            // END
        });
        return radiance;
    }
};

// The part of the sky about L that fills d_omega steradians, as a lamp.
template <class Sky>
DirectionalLight lamp_of(const Sky& sky, const glm::vec3& L, float d_omega) {
    // SOLUTION 04.2
    return {L, sky(L) * d_omega};
    // HANDOUT
    // return {L, d_omega > 0 ? sky(L) : Rgb<float>(0.0F)};  // TODO 04.2: radiance or irradiance?
    // END
}

// Lesson 3's Lambert, whose integral is pi Cd.
struct UnnormalisedLambert {
    Rgb<float> Cd;
    template <Real T>
    Rgb<T> operator()(const Incidence<T>&) const {
        return Rgb<T>(lambert_unnormalised(Cd));
    }
    Rgb<float> ambient_albedo() const {
        // SOLUTION 04.3
        return Cd * std::numbers::pi_v<float>;
        // HANDOUT
        // return Cd;  // TODO 04.3: lesson 1's guess
        // END
    }
};

}  // namespace glint
