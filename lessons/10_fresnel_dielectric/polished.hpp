// What lessons 10 to 13 show reflectances on: a perfectly smooth surface. Its BRDF is a delta, so
// that of the sum over all directions (lesson 4) one is left, the mirror direction R of the viewer:
//
//     L_o = what comes from beneath the surface + reflectance(theta) * L_i(R)
#pragma once

#include "lessons/04_rendering_equation/rendering_equation.hpp"
#include "lessons/08_normalised_lambert/normalised_lambert.hpp"
#include "framework/scene/studio.hpp"

namespace glint {

// Reflectance is a functor: Rgb<T> operator()(const T& cos_i) const, 0..1.
template <class Reflectance>
struct Polished {
    Lit<NormalisedLambert> beneath;
    Reflectance reflectance;
    Studio studio{};
    bool shows_the_studio = false;  // a wall of light instead: what is to be seen in the mirrors

    template <class T>
    using Varyings = Lit<NormalisedLambert>::Varyings<T>;
    static Varyings<float> vertex(const Vertex& v) { return {v.position, v.normal}; }

    // A normal that looks away from the viewer, as at silhouettes, is seen at grazing incidence.
    template <Real T, class Noting = Silent>
    Rgb<T> operator()(const Varyings<T>& in, const Noting& note = {}) const {
        const Vec3<T> N = normalize_or(in.normal, Vec3<T>(T(0.0F)));
        const Vec3<T> V = normalize(beneath.eye - in.position);
        if (shows_the_studio) {
            return studio(-V);
        }
        const T cosine = max(dot(N, V), T(0.0F));
        const Vec3<T> R = T(2.0F) * cosine * N - V;
        const Rgb<T> share = reflectance(cosine);
        const Rgb<T> mirrored = studio(R);
        note("cos(theta)", cosine);
        note("reflectance", share);
        note("mirrored light", mirrored);
        return beneath(in) + share * mirrored;
    }
};

}  // namespace glint
