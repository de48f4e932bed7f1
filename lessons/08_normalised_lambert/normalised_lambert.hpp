// Lesson 8: Lambert's BRDF that conserves energy. The hemisphere integral of cos is pi:
//
//     integral of Cd cos(theta) d omega = pi Cd <= 1      so      BRDF = Cd / pi,  albedo = Cd
#pragma once

#include "framework/math/incidence.hpp"

#include <numbers>

namespace glint {

template <Real T>
inline const T inverse_pi = T(std::numbers::inv_pi);

struct NormalisedLambert {
    Rgb<float> Cd;  // diffuse albedo, 0..1: exactly the share of light that is reflected

    template <Real T>
    Rgb<T> operator()(const Incidence<T>&) const {
        // SOLUTION 08.1
        return Rgb<T>(Cd) * inverse_pi<T>;
        // HANDOUT
        // return Rgb<T>(Cd);  // TODO 08.1: conserve energy
        // END
    }
    Rgb<float> ambient_albedo() const {
        // SOLUTION 08.2
        return Cd;  // La * integral of Cd/pi cos d omega = La * Cd
        // HANDOUT
        // return Rgb<float>(0.0F);  // TODO 08.2: the reflected share of constant light
        // END
    }
};

}  // namespace glint
