// The model of this lesson, its highlight only where it shows: a highlight is a narrow cone, and of
// many lights a pixel lies within reach of few.
#pragma once

#include "lessons/15_engine_integration/engine_phong.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace glint {

// The radiance whose loss makes no 8-bit sRGB value wrong by more than this many codes: the curve
// is steepest at black, 12.92 of 255 codes.
constexpr float radiance_of_codes(float codes) {
    return codes / (255 * 12.92F);
}

// The V.R up to which the highlights of all lights together stay below `least` of radiance, for
//
//     sum of (n + 2)/(2 pi) F c^n E (N.L) <= (n + 2)/(2 pi) c^n max(F0, 1) sum of E
//
// 2 (so nowhere) where they never reach it; -2 (everywhere) for least = 0, n = 0, and point lights,
// which can be arbitrarily near.
inline float highlight_from(const EnginePhong& phong, const Lighting& lighting, float least) {
    float sum = 0;
    for (const DirectionalLight& light : lighting.directional) {
        sum += std::max({light.irradiance.r, light.irradiance.g, light.irradiance.b});
    }
    const float strongest = std::max({phong.F0.r, phong.F0.g, phong.F0.b, 1.0F});
    const float share = least / (phong_normalisation(phong.n) * strongest * sum);
    if (!lighting.point.empty() || !(least > 0.0F)) {
        return -2.0F;
    }
    return share >= 1.0F || sum == 0.0F ? 2.0F
           : phong.n > 0.0F             ? std::pow(share, 1 / phong.n)
                                        : -2.0F;
}

struct WhereItShows {
    EnginePhong phong;
    float highlight_from;

    // One lane within reach makes all compute it; the others leave it out nonetheless, as alone.
    template <Real T>
    Rgb<T> operator()(const Incidence<T>& g) const {
        Rgb<T> f(diffuse<T>());
        if (const MaskOf<T> lanes = shows(g); any(lanes)) {
            f = select(lanes, f + highlight(g), f);
        }
        return f;
    }
    template <Real T>
    auto diffuse() const {  // the same in all lanes
        using Uniform = Rgb<std::conditional_t<std::is_same_v<T, double>, double, float>>;
        return diffuse_by_f0(Uniform(phong.Cd), Uniform(phong.F0));
    }
    template <Real T>
    Rgb<T> highlight(const Incidence<T>& g) const {
        return specular_by_angle(Rgb<T>(phong.F0), T(phong.n), g);
    }
    template <Real T>
    MaskOf<T> shows(const Incidence<T>& g) const {
        return v_dot_r_by_cosines(g) > T(highlight_from);
    }
    Rgb<float> ambient_albedo() const { return phong.ambient_albedo(); }
};

}  // namespace glint
