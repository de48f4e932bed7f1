// The forms put together: one BRDF, as dear or as cheap as it is asked for.
#pragma once

#include "lessons/11_fresnel_conductor/metals.hpp"
#include "lessons/17_speed_and_accuracy/thrifty_phong.hpp"
#include "framework/geometry/mesh.hpp"
#include "framework/math/polynomial.hpp"

namespace glint {

// The surface of a material: one of lesson 11's metals by name, else what has its F0 and k = 0.
inline Surface surface_of(const Material& m) {
    Surface s{m.diffuse, {}, Rgb<float>(0.0F), m.specular, {}, m.exponent};
    const auto metal = std::find_if(metals.begin(), metals.end(),
                                    [&](const Metal& each) { return each.name == m.name; });
    for (int band = 0; band < 3; ++band) {
        const float r = std::sqrt(std::min(m.specular[band], 0.999F));
        s.ior[band] = metal != metals.end() ? metal->ior[band] : (1 + r) / (1 - r);
        s.k[band] = metal != metals.end() ? metal->k[band] : 0.0F;
        s.F0[band] = f0_conductor(s.ior[band], s.k[band]);
        const float seventh = fresnel_conductor(s.ior[band], s.k[band], 1.0F / 7).unpolarised;
        s.dip[band] = lazanyi_dip(s.F0[band], seventh);
    }
    return s;
}

// x^n of 1e-37 <= x <= 1 as 2^(n log2 x), by four terms each where pow() takes nine and seven: off
// by up to 0.03 codes where white is 1. The reference takes no short cut.
template <Real T>
T short_pow(const T& x, const T& n) {
    if constexpr (std::same_as<T, double>) {
        return pow(x, n);
    } else {
        using I = IntOf<T>;
        const I above = bits_of(x) - I(bits_of(0.707106781F));
        const T f = float_from_bits(bits_of(x) - (above & I(~0x7fffff))) - T(1.0F);
        const T log_f = polynomial(f, 1.44230705F, -0.724699847F, 0.510183237F, -0.322623591F);
        const T y = max(n * fma(f, log_f, to_float(above >> 23)), T(-126.0F));
        const T shift(0x1.8p23F);
        const T k = (y + shift) - shift;
        return scale(polynomial(y - k, 0.999928074F, 0.693260985F, 0.242611122F, 0.0551716691F), k);
    }
}

// Lesson 15's; what reflects nothing has no highlight anywhere.
inline float highlight_from(const Surface& s, const Lighting& lighting, float least) {
    return s.F0 == Rgb<float>(0.0F) ? 2.0F
                                    : highlight_from(EnginePhong{s.Cd, s.F0, s.n}, lighting, least);
}

struct ThriftyPhong {
    Surface surface;
    Fresnel fresnel;
    bool few_terms;
    float highlight_from;  // V.R; lesson 15

    template <Real T>
    Rgb<T> operator()(const Incidence<T>& g) const {
        const Rgb<T> diffuse = diffuse_by_f0(Rgb<T>(surface.Cd), Rgb<T>(surface.F0));
        const MaskOf<T> shows = v_dot_r_by_cosines(g) > T(highlight_from);
        if (!any(shows)) {
            return diffuse;
        }
        const T cosine = clamp(v_dot_r(g), T(1e-37F), T(1.0F));
        const T n(surface.n);
        const T lobe = few_terms ? short_pow(cosine, n) : phong_lobe(g, n);
        const Rgb<T> highlight =
            reflectance(fresnel, surface, g.NL) * (phong_normalisation(n) * lobe);
        return select(shows, diffuse + highlight, diffuse);
    }
    Rgb<float> ambient_albedo() const { return surface.Cd * (Rgb<float>(1.0F) - surface.F0); }
};

}  // namespace glint
