// Lesson 13: F0 as a colour. Grey for dielectrics; coloured for metals, which have no diffuse part,
// for light that enters a metal is absorbed within a fraction of a micrometre.
#pragma once

#include "framework/image/srgb.hpp"
#include "framework/math/vec.hpp"

#include <array>
#include <string_view>

namespace glint {

// The slides' table: linear F0. Its sRGB column is wrong in four entries (0.21 for 0.19, 0.24 for
// 0.25, 0.78 for 0.79, 0.97 for 0.96), so only the linear one is kept. Gold's 1.00 is a colour
// clamped to the gamut of sRGB; no surface reflects everything.
struct SpecularColour {
    std::string_view name;
    Rgb<float> F0;
    bool metal;
};

inline constexpr std::array<SpecularColour, 10> specular_colours{{
    {"water", Rgb<float>(0.02F, 0.02F, 0.02F), false},
    {"plastic or glass, low", Rgb<float>(0.03F, 0.03F, 0.03F), false},
    {"plastic, high", Rgb<float>(0.05F, 0.05F, 0.05F), false},
    {"glass, high, or ruby", Rgb<float>(0.08F, 0.08F, 0.08F), false},
    {"diamond", Rgb<float>(0.17F, 0.17F, 0.17F), false},
    {"iron", Rgb<float>(0.56F, 0.57F, 0.58F), true},
    {"copper", Rgb<float>(0.95F, 0.64F, 0.54F), true},
    {"gold", Rgb<float>(1.00F, 0.71F, 0.29F), true},
    {"aluminium", Rgb<float>(0.91F, 0.92F, 0.92F), true},
    {"silver", Rgb<float>(0.95F, 0.93F, 0.88F), true},
}};

// What is left for the diffuse reflection of a material.
inline Rgb<float> diffuse_albedo(const Rgb<float>& Cd, bool metal) {
    // SOLUTION 13.1
    return metal ? Rgb<float>(0.0F) : Cd;
    // HANDOUT
    // return metal ? 0.9F * Cd : Cd;  // TODO 13.1: metals have no diffuse reflection
    // END
}

// F0 from a colour that was picked off a screen or a table, sRGB values 0..1: codes for light, by a
// curve that spends more of them on the dark; reflectances are shares of light.
inline Rgb<float> f0_from_srgb(const Rgb<float>& encoded) {
    // SOLUTION 13.2
    Rgb<float> linear;
    for (int band = 0; band < 3; ++band) {
        linear[band] = static_cast<float>(srgb_decode(double{encoded[band]}));
    }
    return linear;
    // HANDOUT
    // return encoded;  // TODO 13.2: to linear
    // END
}

}  // namespace glint
