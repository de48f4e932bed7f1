// Refractive indices of metals at 650, 550 and 450 nm, which stand for red, green and blue.
#pragma once

#include "framework/math/vec.hpp"

#include <array>
#include <string_view>

namespace glint {

struct Metal {
    std::string_view name;
    Rgb<float> ior, k;
};

// Gold, silver and copper: Johnson and Christy 1972; iron: the same, 1974; aluminium: Rakic 1995.
inline constexpr std::array<Metal, 5> metals{{
    {"gold", {0.1556F, 0.4241F, 1.3831F}, {3.6024F, 2.4721F, 1.9155F}},
    {"copper", {0.2378F, 1.0066F, 1.2404F}, {3.6264F, 2.5823F, 2.3929F}},
    {"silver", {0.0522F, 0.0596F, 0.0400F}, {4.4094F, 3.5974F, 2.6484F}},
    {"aluminium", {1.5580F, 1.0152F, 0.6332F}, {7.7124F, 6.6273F, 5.4544F}},
    {"iron", {2.9114F, 2.9497F, 2.5845F}, {3.0893F, 2.9318F, 2.7670F}},
}};

}  // namespace glint
