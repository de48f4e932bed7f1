// The geometry of a reflection: what an isotropic BRDF depends on.
#pragma once

#include "framework/math/vec.hpp"

namespace glint {

// The cosines between the surface normal N, the direction towards the light L and the direction
// towards the viewer V, all of unit length. An isotropic BRDF depends on nothing else. What follows
// from them is made of the vectors all the same: of what is nearly 1 or nearly 0, float cosines
// have lost what counts.
template <Real T>
struct Incidence {
    T NL, NV, LV;
    T VR = T(2.0F) * NL * NV - LV;  // with R = 2 (N.L) N - L, the mirror direction of L
    T along2 = max(T(2.0F) + T(2.0F) * LV - (NL + NV) * (NL + NV), T(0.0F));  // |N x (L + V)|^2
};

// Of vectors of unit length. V.R as 1 - |V - R|^2/2: near 1, where highlights raise it to high
// powers, it is rounded once, and errors of the directions count with |V - R| only; never above 1.
template <Real T>
Incidence<T> incidence(const Vec3<T>& N, const Vec3<T>& L, const Vec3<T>& V) {
    const T NL = dot(N, L);
    const T NV = dot(N, V);
    const Vec3<T> along = L + V - (NL + NV) * N;
    const T along2 = dot(along, along);
    return {NL, NV, dot(L, V), T(1.0F) - T(0.5F) * (along2 + (NL - NV) * (NL - NV)), along2};
}

// V.R. Symmetric in L and V.
template <Real T>
T v_dot_r(const Incidence<T>& g) {
    return g.VR;
}

// The same by the cosines, as it is defined: cheaper, off by up to 2^-22.
template <Real T>
T v_dot_r_by_cosines(const Incidence<T>& g) {
    return T(2.0F) * g.NL * g.NV - g.LV;
}

// sin^2 of the angle from N to L + V, whose length squared is 2 + 2 L.V. 0 where L = -V.
template <Real T>
T sin2_half(const Incidence<T>& g) {
    return g.along2 / max(T(2.0F) + T(2.0F) * g.LV, T(1e-20F));
}

// L.H = V.H, where H = normalize(L + V) is half way between them: the cosine of half their angle,
// by cos(a/2)^2 = (1 + cos a)/2. 0 where L = -V.
template <Real T>
T l_dot_h(const Incidence<T>& g) {
    return sqrt(max(T(0.5F) + T(0.5F) * g.LV, T(0.0F)));
}

}  // namespace glint
