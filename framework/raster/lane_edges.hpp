// The edges of N triangles of less than 64 pixels in width and height: then 32 bits hold all.
#pragma once

#include "framework/raster/pipeline.hpp"
#include "framework/math/lanes.hpp"

#include <cstddef>

namespace glint {

// As Edge of setup.hpp: E(x, y) = a x + b y + c, here at one point, less 1 where the edge is not
// inclusive: inside where no E is negative. A pixel to the right E grows by 256 a, down by 256 b.
template <int N>
struct LaneEdge {
    typename Lanes<N>::Int a, b, e;
};

// The edge opposite to corner i, at px, py in 1/256 pixel, at most 64 pixels from the triangle.
// turned: where its doubled area is negative.
template <int N>
LaneEdge<N> lane_edge(const typename Lanes<N>::Int (&x)[3], const typename Lanes<N>::Int (&y)[3],
                      typename Lanes<N>::Mask turned, std::size_t i, typename Lanes<N>::Int px,
                      typename Lanes<N>::Int py) {
    using I = typename Lanes<N>::Int;
    const std::size_t from = (i + 1) % 3;
    const std::size_t to = (i + 2) % 3;
    const I dx = x[to] - x[from];
    const I dy = y[from] - y[to];
    const I a = select(turned, -dy, dy);
    const I b = select(turned, -dx, dx);
    const auto inclusive = (a > I(0)) | ((a == I(0)) & (b > I(0)));
    return {a, b, a * (px - x[from]) + b * (py - y[from]) - select(inclusive, I(0), I(1))};
}

}  // namespace glint
