// Lesson 8: Lambert's BRDF that conserves energy. The hemisphere integral of cos is pi:
//
//     integral of Cd cos(theta) d omega = pi Cd <= 1      so      BRDF = Cd / pi,  albedo = Cd
#pragma once

#include "framework/math/incidence.hpp"

#include <numbers>

namespace glint {

// 1/pi, for lanes as for one float.
template <Real T>
inline constexpr auto inverse_pi =
    std::numbers::inv_pi_v<std::conditional_t<std::same_as<T, double>, double, float>>;

struct NormalisedLambert {
    Rgb<float> Cd;  // diffuse albedo, 0..1: exactly the share of light that is reflected

    // In 1/sr, the same for all directions.
    template <Real T>
    Rgb<T> operator()(const Incidence<T>&) const {
        // SOLUTION 08.1
        return Rgb<T>(Cd) * inverse_pi<T>;
        // HANDOUT
        // return Rgb<T>(Cd);  // TODO 08.1: conserve energy
        // END
    }

    // The share of constant light from everywhere that is reflected: the integral of the BRDF.
    Rgb<float> ambient_albedo() const {
        // SOLUTION 08.2
        return Cd;
        // HANDOUT
        // return Rgb<float>(0.0F);  // TODO 08.2: the integral of Cd/pi cos d omega
        // END
    }
};

}  // namespace glint
