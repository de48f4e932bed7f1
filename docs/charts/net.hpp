// A net of triangles over a window, and which of them covers each pixel.
#pragma once

#include "framework/image/image.hpp"

namespace glint::charts {

inline constexpr int net_window = 128;  // pixels a side

// Without gaps or overlap, over the window and some more.
struct Net {
    std::vector<glm::dvec2> knots;  // pixels, whole 2^-14 of them
    std::vector<glm::uvec3> triangles;
};

// Knots about so many pixels apart.
Net net_of(double pixels);

// The triangle that covers each pixel's centre, by the oracle; -1 where none does.
Image<std::int32_t> exact_owners(const Net& net);

}  // namespace glint::charts
