// Lesson 4's sum for scenes without point lights. Where lamps are infinitely far, a fragment's
// place tells only where the eye is, and that its pixel tells as well: three varyings instead of
// six, and of neither does the length count. And the diffuse part, the same for all lights, meets
// the sum of their irradiances once.
#pragma once

#include "lessons/15_engine_integration/where_it_shows.hpp"

#include <type_traits>

namespace glint {

struct LitFromAfar {
    static constexpr bool directions_only = true;
    WhereItShows brdf;
    Lighting lighting;  // without point lights

    template <class T>
    struct Varyings {
        Vec3<T> normal, to_eye;
    };
    static Varyings<float> vertex(const Vertex& v) { return {v.normal, glm::vec3(0)}; }

    template <Real T, class Noting = Silent>
    Rgb<T> operator()(const Varyings<T>& in, const Noting& note = {}) const {
        const Vec3<T> N = normalize_or(in.normal, Vec3<T>(T(0.0F)));
        const Vec3<T> V = normalize(in.to_eye);
        Rgb<T> radiance(lighting.ambient * brdf.ambient_albedo());
        note("ambient", radiance);
        Rgb<T> irradiance(T(0.0F));
        for (const DirectionalLight& light : lighting.directional) {
            const Incidence<T> g = incidence(N, Vec3<T>(light.direction), V);
            note("N.L", g.NL);
            note("V.R", v_dot_r(g));
            if constexpr (!std::is_same_v<Noting, Silent>) {
                note("BRDF", brdf(g));  // computed for this alone
            }
            const Rgb<T> E = Rgb<T>(light.irradiance) * max(g.NL, T(0.0F));
            irradiance += E;
            if (const MaskOf<T> shows = brdf.shows(g); any(shows)) {
                radiance = select(shows, radiance + brdf.highlight(g) * E, radiance);
            }
        }
        return radiance + brdf.diffuse<T>() * irradiance;
    }
};

}  // namespace glint
