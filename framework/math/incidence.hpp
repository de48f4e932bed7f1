// The geometry of a reflection: what an isotropic BRDF depends on.
#pragma once

#include "framework/math/vec.hpp"

namespace glint {

// The cosines between the surface normal N, the direction towards the light L and the direction
// towards the viewer V, all of unit length. An isotropic BRDF depends on nothing else.
template <Real T>
struct Incidence {
    T NL, NV, LV;
    // sin^2 of the angle from N to L + V, whose length squared is 2 + 2 L.V. It follows from the
    // cosines; but where it is small they have lost it, if they are float. 0 where L = -V.
    T sin2_half = max(T(2.0F) + T(2.0F) * LV - (NL + NV) * (NL + NV), T(0.0F)) /
                  max(T(2.0F) + T(2.0F) * LV, T(1e-20F));
};

// Of vectors of unit length. The sine is made of them, not of their cosines.
template <Real T>
Incidence<T> incidence(const Vec3<T>& N, const Vec3<T>& L, const Vec3<T>& V) {
    const Vec3<T> sum = L + V;
    const Vec3<T> across = cross(N, sum);
    return {dot(N, L), dot(N, V), dot(L, V), dot(across, across) / max(dot(sum, sum), T(1e-20F))};
}

// V.R, where R = 2 (N.L) N - L is the mirror direction of L. Symmetric in L and V.
// Rounding can take it beyond 1 by a few units in the last place.
template <Real T>
T v_dot_r(const Incidence<T>& g) {
    return T(2.0F) * g.NL * g.NV - g.LV;
}

// L.H = V.H, where H = normalize(L + V) is half way between them: the cosine of half their angle,
// by cos(a/2)^2 = (1 + cos a)/2. 0 where L = -V.
template <Real T>
T l_dot_h(const Incidence<T>& g) {
    return sqrt(max(T(0.5F) + T(0.5F) * g.LV, T(0.0F)));
}

}  // namespace glint
