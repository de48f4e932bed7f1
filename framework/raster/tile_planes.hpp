// A triangle's attributes as planes over the window.
#pragma once

#include "framework/raster/tile.hpp"

namespace glint {

// With S(x, y) = 1/w, varying k at x, y pixels from the anchor is
//     first[k] + (d0[k] + dx[k] x + dy[k] y) / S(x, y)
// where first[k] is its value at a corner of the triangle. Anchored near what is shaded, and
// relative to a corner, so that nothing large cancels.
//
// The planes of N triangles, a group, are set up together and lie side by side: value j of a
// triangle is N floats from its value j + 1.
template <int N>
struct Planes {
    const float* data;
    int count;  // varyings

    static std::size_t size(int count) { return 5 + 4 * static_cast<std::size_t>(count); }
    float x() const { return data[0]; }  // the anchor, pixels from the tile's corner
    float y() const { return data[N]; }
    float s(int i) const { return data[(2 + i) * N]; }  // s0, sx, sy
    float first(int k) const { return data[(5 + k) * N]; }
    float d(int i, int k) const { return data[(5 + (i + 1) * count + k) * N]; }  // d0, dx, dy
};

template <int N>
Planes<N> planes_of(const TileBuffer& tile, std::int32_t triangle, int varyings) {
    const auto start = tile.plane_start[static_cast<std::size_t>(triangle)];
    return {tile.planes.data() + start, varyings};
}

// Sets up the planes of the triangles that own fragments; N is the frame's lanes.
void set_up_planes(const Frame& frame, TileBuffer& tile);

}  // namespace glint
