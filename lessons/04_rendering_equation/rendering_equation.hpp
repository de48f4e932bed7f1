// Lesson 4: the rendering equation (Kajiya 1986), for surfaces that do not glow:
//
//     L_o(V) = integral over the hemisphere of BRDF(L, V) L_i(L) (N.L) d omega
//
// A directional light is a delta in L_i, so its part of the integral is BRDF * E * (N.L): the sum
// over lights. What comes from all directions alike, L_i = La, leaves the integral as a factor:
//     L_o = La * albedo,   for Lambert's BRDF the diffuse albedo: the "ambient term", derived.
#pragma once

#include "lessons/03_brdf/brdf.hpp"

namespace glint {

// A BRDF is a functor: Rgb<T> operator()(const Incidence<T>&) const, in 1/sr, for N.L > 0, and
// Rgb<float> ambient_albedo() const, the share of constant light from everywhere that it reflects.
//
// Lit is the fragment shader that all later lessons use; they supply only the BRDF.
template <class Brdf>
struct Lit {
    Brdf brdf;
    Lighting lighting;
    glm::vec3 eye;

    template <class T>
    struct Varyings {
        Vec3<T> position;
        Vec3<T> normal;
    };
    static Varyings<float> vertex(const Vertex& v) { return {v.position, v.normal}; }

    // An interpolated normal of length zero reflects ambient light only; one that looks away from
    // the viewer, as at silhouettes, is taken as it is.
    template <Real T, class Noting = Silent>
    Rgb<T> operator()(const Varyings<T>& in, const Noting& note = {}) const {
        const Vec3<T> N = normalize_or(in.normal, Vec3<T>(T(0.0F)));
        const Vec3<T> V = normalize(eye - in.position);
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

}  // namespace glint
