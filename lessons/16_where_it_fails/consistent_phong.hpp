// Lesson 16: what the slides do not say, and a fix that keeps both rules.
//
//     diffuse:   21/(20 pi) Cd (1 - F0) (1 - (1 - N.L)^5) (1 - (1 - N.V)^5)      reciprocal; its
//                albedo is exactly Cd (1 - F_schlick(theta_i)), for 2 int (1-(1-c)^5) c dc = 20/21
//                (after Shirley, Smits, Hu and Lafortune 1997)
//     specular:  F(L.H) (n + 2)/(2 pi) (V.R)^n, H = normalize(L + V): reciprocal, as L.H = V.H
#pragma once

#include "lessons/14_combined/combined.hpp"

namespace glint {

// N.L and N.V below 0 count as 0: at the horizon nothing enters or leaves.
template <Real T>
Rgb<T> coupled_diffuse(const Rgb<T>& Cd, const Rgb<T>& F0, const Incidence<T>& g) {
    // SOLUTION 16.1
    const T enters = T(1.0F) - schlick_weight(g.NL);
    const T leaves = T(1.0F) - schlick_weight(g.NV);
    const T both = enters * leaves;  // first, so that swapping them changes no bit
    return Cd * (Rgb<T>(T(1.0F)) - F0) * (T(21.0 / 20.0) * inverse_pi<T> * both);
    // HANDOUT
    // return select(g.NL > T(0.0F), diffuse_by_f0(Cd, F0), F0);  // TODO 16.1: couple both angles
    // END
}

template <Real T>
Rgb<T> reciprocal_specular(const Rgb<T>& F0, const T& n, const Incidence<T>& g) {
    // SOLUTION 16.2
    return schlick(F0, l_dot_h(g)) * normalised_phong(g, n);
    // HANDOUT
    // return specular_by_angle(F0, n, g);  // TODO 16.2: the half vector's angle
    // END
}

struct ConsistentPhong {
    Rgb<float> Cd, F0;
    float n;

    template <Real T>
    Rgb<T> operator()(const Incidence<T>& g) const {
        const Rgb<T> f0(F0);
        return coupled_diffuse(Rgb<T>(Cd), f0, g) + reciprocal_specular(f0, T(n), g);
    }
    // The diffuse albedo for light from everywhere: Cd (1 - F0) 20/21, as the mean of
    // 1 - F_schlick over the hemisphere is (1 - F0) 20/21.
    Rgb<float> ambient_albedo() const { return Cd * (Rgb<float>(1.0F) - F0) * (20.0F / 21.0F); }
};

}  // namespace glint
