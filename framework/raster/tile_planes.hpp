// A triangle's attributes as planes over a tile.
#pragma once

#include "framework/raster/tile.hpp"

namespace glint {

// With S(x, y) = 1/w, varying k at x, y pixels from the tile's corner is
//     first[k] + (d0[k] + dx[k] x + dy[k] y) / S(x, y)
// where first[k] is its value at the triangle's corner 0. Anchored at the tile, and relative to a
// corner of the triangle, so that nothing large cancels.
struct Planes {
    float* data;
    int count;  // varyings

    static std::size_t size(int count) { return 4 + 4 * static_cast<std::size_t>(count); }
    float& s(int i) const { return data[i]; }  // s0, sx, sy
    float* first() const { return data + 4; }
    float* d(int i) const { return data + 4 + (i + 1) * count; }  // d0, dx, dy
};

inline Planes planes_of(TileBuffer& tile, std::int32_t triangle, int varyings) {
    const auto start = tile.plane_start[static_cast<std::size_t>(triangle)];
    return {tile.planes.data() + start, varyings};
}

// Sets up the planes of the triangles that own fragments.
void set_up_planes(const Frame& frame, TileBuffer& tile);

}  // namespace glint
