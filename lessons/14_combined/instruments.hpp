// What the gonioreflectometer says of a BRDF, as colours on a surface that one light falls on: the
// total albedo for light from there, or how far swapping light and viewer changes the BRDF.
#pragma once

#include "lessons/06_energy/furnace.hpp"

namespace glint {

// |f(L,V) - f(V,L)| as a share of the larger one; green stands for all.
template <class Brdf, Real T>
T relative_reciprocity_error(const Brdf& brdf, const Incidence<T>& g) {
    const T f = brdf(g).g;
    const T difference = reciprocity_error(brdf, g).g;
    return abs(difference) / max(max(f, f - difference), T(1e-30F));
}

template <class Brdf>
struct Instruments {
    Brdf brdf;
    AlbedoCurve albedo;
    bool reciprocity;  // else the total albedo
    glm::vec3 to_light, eye;

    template <class T>
    using Varyings = typename Lit<Brdf>::template Varyings<T>;
    static Varyings<float> vertex(const Vertex& v) { return {v.position, v.normal}; }

    template <Real T, class Noting = Silent>
    Rgb<T> operator()(const Varyings<T>& in, const Noting& note = {}) const {
        const Vec3<T> N = normalize_or(in.normal, Vec3<T>(T(0.0F)));
        const Incidence<T> g = incidence(N, Vec3<T>(to_light), normalize(eye - in.position));
        const T share = reciprocity ? relative_reciprocity_error(brdf, g) : albedo(g.NL);
        note("N.L", g.NL);
        note("N.V", g.NV);
        note(reciprocity ? "reciprocity error" : "total albedo", share);
        const Rgb<T> unlit(T(0.03F));
        const T lit = clamp(g.NL * 100.0F, T(0.0F), T(1.0F));
        return mix(unlit, colour_of_share(share, 80), Rgb<T>(lit));
    }
};

}  // namespace glint
