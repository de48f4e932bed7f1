// Lesson 15: the whole, as an engine takes it - normalised Phong with Fresnel:
//
//     L_o = (Cd (1 - F0)/pi + (n + 2)/(2 pi) F(theta_i) (V.R)^n) E (N.L) + La Cd (1 - F0)
#pragma once

#include "lessons/04_rendering_equation/rendering_equation.hpp"
#include "lessons/14_combined/combined.hpp"

namespace glint {

struct EnginePhong {
    Rgb<float> Cd, F0;  // diffuse albedo (0 for metals) and reflectance at normal incidence
    float n;            // Phong exponent

    template <Real T>
    Rgb<T> operator()(const Incidence<T>& g) const {
        const Rgb<T> f0(F0);
        // SOLUTION 15.1
        return diffuse_by_f0(Rgb<T>(Cd), f0) + specular_by_angle(f0, T(n), g);
        // HANDOUT
        // const auto lit = g.NL > T(0.0F);
        // return select(lit, diffuse_by_f0(Rgb<T>(Cd), f0), f0);  // TODO 15.1: and the highlight
        // END
    }

    // Constant light from everywhere meets what is left for the diffuse reflection.
    Rgb<float> ambient_albedo() const {
        // SOLUTION 15.2
        return Cd * (Rgb<float>(1.0F) - F0);
        // HANDOUT
        // return Cd;  // TODO 15.2: the reflectance that remains
        // END
    }
};

// Engines that drop pi everywhere - Cd and (n + 2)/2 - draw the same picture when their lights are
// given as E/pi, the radiance of a white Lambertian that faces them. F0 stays: it is a reflectance.
inline Lighting lights_without_pi(const Lighting& lighting) {
    Lighting scaled = lighting;
    // SOLUTION 15.3
    for (DirectionalLight& light : scaled.directional) {
        light.irradiance *= inverse_pi<float>;
    }
    for (PointLight& light : scaled.point) {
        light.intensity *= inverse_pi<float>;
    }
    // HANDOUT
    // // TODO 15.3: E/pi
    // END
    return scaled;
}

struct EnginePhongWithoutPi {
    EnginePhong with_pi;
    template <Real T>
    Rgb<T> operator()(const Incidence<T>& g) const {
        return with_pi(g) * T(std::numbers::pi);
    }
    Rgb<float> ambient_albedo() const { return with_pi.ambient_albedo(); }
};

}  // namespace glint
