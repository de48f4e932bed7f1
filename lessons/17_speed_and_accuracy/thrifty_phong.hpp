// Lesson 17: model no more than the scene needs. The whole model with Fresnel's formula for metals,
// and each of its parts in cheaper forms: what may be taken is what stays within a tolerance.
#pragma once

#include "lessons/11_fresnel_conductor/fresnel_conductor.hpp"
#include "lessons/15_engine_integration/where_it_shows.hpp"
#include "framework/image/srgb.hpp"

#include <algorithm>
#include <span>

namespace glint {

// The error of a colour, linear and seen at 0..1, as 8-bit sRGB codes before they are rounded.
inline double code_error(double radiance, double exact) {
    // SOLUTION 17.1
    return 255 * std::abs(srgb_encode(std::clamp(radiance, 0.0, 1.0)) -
                          srgb_encode(std::clamp(exact, 0.0, 1.0)));
    // HANDOUT
    // return 255 * std::abs(radiance - exact);  // TODO 17.1: in codes
    // END
}

// A way to compute something: what it takes, and by how much it is off at most.
struct Method {
    double ns, error;
};

// Which of them to take: the cheapest whose error is within the tolerance; where there is none, the
// one of least error. The first of equals. methods is not empty.
inline std::size_t cheapest(std::span<const Method> methods, double tolerance) {
    // SOLUTION 17.2
    const auto better = [tolerance](const Method& a, const Method& b) {
        const bool a_fits = a.error <= tolerance;
        const bool b_fits = b.error <= tolerance;
        return a_fits != b_fits ? a_fits : a_fits ? a.ns < b.ns : a.error < b.error;
    };
    const auto best = std::min_element(methods.begin(), methods.end(), better);
    return static_cast<std::size_t>(best - methods.begin());
    // HANDOUT
    // return tolerance < 0 ? methods.size() : 0;  // TODO 17.2: choose
    // END
}

// The forms of reflectance, ever cheaper.
enum class Fresnel { exact, lazanyi, schlick, f0 };

// A metal or dielectric by its index, and what follows from it.
struct Surface {
    Rgb<float> Cd, ior, k, F0, dip;
    float n;
};

template <Real T>
Rgb<T> reflectance(Fresnel form, const Surface& s, const T& cos_i) {
    // SOLUTION 17.3
    if (form == Fresnel::exact) {
        return {fresnel_conductor(T(s.ior.r), T(s.k.r), cos_i).unpolarised,
                fresnel_conductor(T(s.ior.g), T(s.k.g), cos_i).unpolarised,
                fresnel_conductor(T(s.ior.b), T(s.k.b), cos_i).unpolarised};
    }
    const Rgb<T> F0(s.F0);
    return form == Fresnel::lazanyi   ? lazanyi(F0, Rgb<T>(s.dip), cos_i)
           : form == Fresnel::schlick ? schlick(F0, cos_i)
                                      : F0;
    // HANDOUT
    // return form == Fresnel::exact ? Rgb<T>(s.F0) : Rgb<T>(s.F0) * cos_i;  // TODO 17.3
    // END
}

}  // namespace glint
