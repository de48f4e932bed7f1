// Lesson 1: light as it was first drawn - ambient + Kd (N.L) + Ks (V.R)^n (Phong 1975, as the
// slides start from it). The constants are tweaked by hand until the picture pleases.
#pragma once

#include "framework/scene/light.hpp"
#include "framework/raster/shader.hpp"
#include "framework/math/pow.hpp"

namespace glint {

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
        Rgb<T> colour = Rgb<T>(lighting.ambient * material.diffuse);
        note("ambient", colour);
        for_each_light(lighting, in.position, [&](const Incident<T>& light) {
            const Vec3<T> L = light.direction;
            const T cosine = max(dot(N, L), 0.0F);
            const Vec3<T> R = T(2.0F) * dot(N, L) * N - L;
            const T highlight = select(cosine > T(0.0F),
                                       pow(clamp(dot(V, R), 0.0F, 1.0F), material.exponent), 0.0F);
            const Rgb<T> diffuse = material.diffuse * cosine * light.irradiance;
            const Rgb<T> specular = material.specular * highlight * light.irradiance;
            note("N.L", cosine);
            note("V.R^n", highlight);
            note("diffuse", diffuse);
            note("specular", specular);
            colour += diffuse + specular;
        });
        return colour;
    }
};

}  // namespace glint
