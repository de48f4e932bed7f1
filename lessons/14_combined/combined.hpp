// Lesson 14: the more is reflected at the surface, the less is left to enter and come out diffuse.
//
//     Cd' = Cd (1 - F(theta_i))    conserves energy at every angle; not reciprocal
//     Cd' = Cd (1 - F0)            reciprocal; with F(theta_i) in the lobe, above 1 near grazing
#pragma once

#include "lessons/08_normalised_lambert/normalised_lambert.hpp"
#include "lessons/09_normalised_phong/normalised_phong.hpp"
#include "lessons/12_schlick/schlick.hpp"

namespace glint {

// The diffuse part, in 1/sr, by the light's angle.
template <Real T>
Rgb<T> diffuse_by_angle(const Rgb<T>& Cd, const Rgb<T>& F0, const Incidence<T>& g) {
    // SOLUTION 14.1
    return Cd * (Rgb<T>(T(1.0F)) - schlick(F0, g.NL)) * inverse_pi<T>;
    // HANDOUT
    // return select(g.NL > T(0.0F), Cd, F0) * inverse_pi<T>;  // TODO 14.1: less what is reflected
    // END
}

// The diffuse part, in 1/sr, by F0: what the slides settle on.
template <Real T>
Rgb<T> diffuse_by_f0(const Rgb<T>& Cd, const Rgb<T>& F0) {
    // SOLUTION 14.2
    return Cd * (Rgb<T>(T(1.0F)) - F0) * inverse_pi<T>;
    // HANDOUT
    // return min(Cd, Cd + F0) * inverse_pi<T>;  // TODO 14.2: less what is reflected at 0 degrees
    // END
}

// The specular part: the lobe, coloured by Schlick's reflectance at the light's angle.
template <Real T>
Rgb<T> specular_by_angle(const Rgb<T>& F0, const T& n, const Incidence<T>& g) {
    // SOLUTION 14.3
    return schlick(F0, g.NL) * normalised_phong(g, n);
    // HANDOUT
    // return F0 * normalised_phong(g, n);  // TODO 14.3: Fresnel at the light's angle
    // END
}

// How much of Cd is left.
enum class Remains { all, by_angle, by_f0 };

struct Combined {
    Rgb<float> Cd, F0;  // diffuse albedo (0 for metals) and reflectance at normal incidence
    float n;            // Phong exponent
    Remains remains;

    template <Real T>
    Rgb<T> operator()(const Incidence<T>& g) const {
        const Rgb<T> cd(Cd);
        const Rgb<T> f0(F0);
        const Rgb<T> diffuse = remains == Remains::all        ? cd * inverse_pi<T>
                               : remains == Remains::by_angle ? diffuse_by_angle(cd, f0, g)
                                                              : diffuse_by_f0(cd, f0);
        return diffuse + specular_by_angle(f0, T(n), g);
    }

    // The diffuse part of light from everywhere. By angle: the mean of 1 - F over the hemisphere,
    // weighed by cos, is (1 - F0) 20/21, for 2 integral (1 - c)^5 c dc = 1/21.
    Rgb<float> ambient_albedo() const {
        const float share = remains == Remains::by_angle ? 20.0F / 21.0F : 1.0F;
        return remains == Remains::all ? Cd : Cd * (Rgb<float>(1.0F) - F0) * share;
    }
};

}  // namespace glint
