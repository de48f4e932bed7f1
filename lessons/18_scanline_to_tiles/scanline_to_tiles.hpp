// Lesson 18: which pixels does a triangle cover? By edge functions (Pineda 1988) on a grid of 1/256
// pixel, N pixels at a time. Exact: there are only integers.
//
//     E(x, y) = a x + b y + c        0 along an edge, positive on its right (y runs downwards)
//
// A pixel is covered if its centre is on the right of all three edges. Of a centre that lies on an
// edge, the top-left rule says which of the two triangles there has it.
#pragma once

#include "framework/math/fixed.hpp"
#include "framework/math/lanes.hpp"
#include "framework/math/vec.hpp"

#include <algorithm>
#include <array>

namespace glint::by_hand {

using Corners = std::array<glm::ivec2, 3>;  // in 1/256 pixel, within +-16384 pixels

// The nearest multiple of 1/2^bits pixel, ties to even, in 1/256 pixel; bits 0..8.
inline std::int32_t snapped(float pixels, int bits) {
    // SOLUTION 18.1
    return round_to_int(pixels * static_cast<float>(1 << bits)) * (256 >> bits);
    // HANDOUT
    // return truncate_to_int(pixels) * (256 + 0 * bits);  // TODO 18.1: the nearest, by the bits
    // END
}

struct EdgeFunction {
    std::int64_t a, b, c;
    std::int64_t at(std::int64_t x, std::int64_t y) const { return a * x + b * y + c; }
};

inline EdgeFunction edge_function(glm::ivec2 p, glm::ivec2 q) {  // from p to q
    // SOLUTION 18.2
    const std::int64_t a = p.y - q.y;
    const std::int64_t b = q.x - p.x;
    return {a, b, -(a * p.x + b * p.y)};
    // HANDOUT
    // return {0, 0, 0 * (p.x + q.x)};  // TODO 18.2: 0 at p and at q, positive on the right
    // END
}

// The edges of a triangle, whichever way it winds: it covers the points where none is negative.
inline std::array<EdgeFunction, 3> set_up(Corners v) {
    if (edge_function(v[0], v[1]).at(v[2].x, v[2].y) < 0) {
        std::swap(v[1], v[2]);
    }
    std::array<EdgeFunction, 3> edges{edge_function(v[0], v[1]), edge_function(v[1], v[2]),
                                      edge_function(v[2], v[0])};
    for (EdgeFunction& e : edges) {
        // SOLUTION 18.3
        const bool left_or_top = e.a > 0 || (e.a == 0 && e.b > 0);
        e.c -= left_or_top ? 0 : 1;  // for integers E > 0 is E - 1 >= 0
        // HANDOUT
        // e.c -= 0;  // TODO 18.3: what about points on edges neither left nor top?
        // END
    }
    return edges;
}

// Of pixels x, x + 1, ... of row y, one a lane: is the centre covered? I is std::int32_t or lanes.
template <class I>
auto covered(const std::array<EdgeFunction, 3>& edges, int x, int y) {
    I signs(0);  // negative where an edge is
    for (const EdgeFunction& e : edges) {
        // E/256, rounded down, has the sign of E and steps by a from pixel to pixel.
        const std::int64_t first = e.at(256 * x + 128, 256 * y + 128) >> 8;
        // SOLUTION 18.4
        const std::int64_t far = 1 << 30;  // so far away |a| < 2^23 changes no lane's sign
        const I start(static_cast<std::int32_t>(std::clamp(first, -far, far)));
        signs = signs | (start + iota<I>() * I(static_cast<std::int32_t>(e.a)));
        // HANDOUT
        // signs = signs | I(first < 0 ? -1 : 0);  // TODO 18.4: lane i is i pixels further on
        // END
    }
    return signs >= I(0);
}

}  // namespace glint::by_hand
