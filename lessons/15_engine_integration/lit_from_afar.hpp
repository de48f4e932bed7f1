// Lesson 4's sum for scenes without point lights: where lamps are infinitely far, a fragment's
// place tells only where the eye is, and that its pixel tells as well. Three varyings instead of
// six, and of neither does the length count.
#pragma once

#include "lessons/04_rendering_equation/rendering_equation.hpp"

namespace glint {

template <class Brdf>
struct LitFromAfar {
    static constexpr bool directions_only = true;
    Lit<Brdf> lit;  // without point lights; its eye is not asked for

    template <class T>
    struct Varyings {
        Vec3<T> normal, to_eye;
    };
    static Varyings<float> vertex(const Vertex& v) { return {v.normal, glm::vec3(0)}; }

    template <Real T, class Noting = Silent>
    Rgb<T> operator()(const Varyings<T>& in, const Noting& note = {}) const {
        return lit.towards(normalize(in.to_eye), {Vec3<T>(T(0.0F)), in.normal}, note);
    }
};

}  // namespace glint
