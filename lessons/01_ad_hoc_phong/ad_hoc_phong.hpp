// Lesson 1: light as it was first drawn (Phong 1975, in the form that the slides start from):
//
//     colour = Ka + sum over the lights of (Kd (N.L) + Ks (V.R)^n) light
//
// Ka is the ambient light times Kd. Kd, Ks and n are tweaked by hand until the picture pleases.
#pragma once

#include "framework/scene/light.hpp"
#include "framework/raster/shader.hpp"
#include "framework/math/pow.hpp"

namespace glint {

// N.L, the share of its full strength that a light has on a matt surface; 0 below the horizon.
template <Real T>
T matt_shading(const Vec3<T>& N, const Vec3<T>& L) {
    // SOLUTION 01.1
    return max(dot(N, L), 0.0F);
    // HANDOUT
    // return abs(dot(N, L));  // TODO 01.1: what about light from behind?
    // END
}

// R, where a mirror would send the light from L. Of unit length as N and L are.
template <Real T>
Vec3<T> mirrored(const Vec3<T>& N, const Vec3<T>& L) {
    // SOLUTION 01.2
    return 2.0F * dot(N, L) * N - L;
    // HANDOUT
    // return normalize(N + L);  // TODO 01.2: not the mirror direction yet
    // END
}

// (V.R)^n; 0 where the light is below the horizon or the mirror direction looks away from V.
template <Real T>
T highlight(const Vec3<T>& N, const Vec3<T>& L, const Vec3<T>& V, const T& n) {
    const Vec3<T> apart = V - mirrored(N, L);
    const T cosine = clamp(1.0F - 0.5F * dot(apart, apart), 0.0F, 1.0F);  // V.R, but near 1 exact
    // SOLUTION 01.3
    const auto seen = (dot(N, L) > T(0.0F)) & (cosine > T(0.0F));
    return select(MaskOf<T>(seen), pow(cosine, n), T(0.0F));
    // HANDOUT
    // return min(T(0.2F) * cosine, n);  // TODO 01.3: n makes it tight; none from lights below
    // END
}

struct AdHocPhong {
    Material material;
    Lighting lighting;
    glm::vec3 eye;

    template <class T>
    struct Varyings {
        Vec3<T> position;
        Vec3<T> normal;
    };
    static Varyings<float> vertex(const Vertex& v) { return {v.position, v.normal}; }

    template <Real T, class Noting = Silent>
    Rgb<T> operator()(const Varyings<T>& in, const Noting& note = {}) const {
        const Vec3<T> N = normalize_or(in.normal, Vec3<T>(T(0.0F)));
        const Vec3<T> V = normalize(eye - in.position);
        Rgb<T> colour(lighting.ambient * material.diffuse);
        note("ambient", colour);
        for_each_light(lighting, in.position, [&](const Incident<T>& light) {
            const Vec3<T> L = light.direction;
            const Rgb<T> diffuse = material.diffuse * matt_shading(N, L);
            const Rgb<T> specular = material.specular * highlight(N, L, V, T(material.exponent));
            note("N.L", dot(N, L));
            note("Kd (N.L)", diffuse);
            note("Ks (V.R)^n", specular);
            colour += (diffuse + specular) * light.irradiance;
        });
        return colour;
    }
};

}  // namespace glint
