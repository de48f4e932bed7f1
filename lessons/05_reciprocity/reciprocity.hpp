// Lesson 5: Helmholtz reciprocity - a BRDF stays the same when light and viewer change places:
//
//     f(L, V) = f(V, L)
//
// (V.R)^n as a BRDF obeys, because V.R = 2 (N.L) (N.V) - L.V is the same both ways. Lesson 1's
// highlight, which is not multiplied by N.L, does not.
#pragma once

#include "lessons/03_brdf/brdf.hpp"

namespace glint {

// Light and viewer change places.
template <Real T>
Incidence<T> swapped(const Incidence<T>& g) {
    // SOLUTION 05.1
    return {g.NV, g.NL, g.LV, g.VR, g.along2};
    // HANDOUT
    // return g;  // TODO 05.1: what were N.L and N.V is now N.V and N.L
    // END
}

// Lesson 1's highlight as a BRDF: what it sends out, (V.R)^n E, per irradiance E (N.L). 0 where
// N.L <= 0. Without bound near the horizon.
struct ClassicPhong {
    float n;
    template <Real T>
    Rgb<T> operator()(const Incidence<T>& g) const {
        const T radiance = phong_lobe(g, T(n));
        // SOLUTION 05.2
        return Rgb<T>(select(g.NL > T(0.0F), radiance / g.NL, T(0.0F)));
        // HANDOUT
        // return Rgb<T>(radiance);  // TODO 05.2: per irradiance
        // END
    }
};

// The highlight as the slides have it, (V.R)^n E (N.L): its BRDF is the lobe.
struct PhongLobe {
    float n;
    template <Real T>
    Rgb<T> operator()(const Incidence<T>& g) const {
        return Rgb<T>(phong_lobe(g, T(n)));
    }
};

}  // namespace glint
