// A triangle's attributes as planes over the window.
#pragma once

#include "framework/raster/tile.hpp"

namespace glint {

// With S(x, y) = 1/w in units of its value at the anchor, varying k at x, y pixels from the anchor
// is
//     first[k] + (d0[k] + dx[k] x + dy[k] y) / S(x, y),   S(x, y) = 1 + sx x + sy y
// where first[k] is its value at a corner of the triangle. The anchor is the farthest corner, or
// of large triangles the farthest of the tile, where S is smallest, so that S does not cancel;
// where 1/w more than doubles, first is of the nearest, so that near the eye nothing large cancels.
// Where neither holds for any triangle of a tile, all d0 are 0 and not asked for.
//
// Of shaders that ask for directions only, they are instead the planes of S(x, y) times the
// varyings,
//     first[k] + dx[k] x + dy[k] y
// where first[k] is the value at the anchor, and neither d0 nor S is asked for.
//
// N triangles that follow each other in the tile, from a multiple of N on, are a group. Their
// planes are set up together and lie side by side: value j of a triangle is N floats from its value
// j + 1. The values are
//     the anchor's x and y, pixels from the tile's corner; sx, sy
//     all first, all dx, all dy, all d0
inline std::size_t plane_values(int varyings) {
    return 4 + 4 * static_cast<std::size_t>(varyings);
}

// Where the values of triangle number `triangle` of the tile begin.
template <int N>
const float* planes_of(const TileBuffer& tile, std::int32_t triangle) {
    const auto group = static_cast<std::size_t>(triangle) / N;
    const int lane = triangle & (N - 1);
    return &tile.planes[static_cast<std::size_t>(tile.plane_start[group] + lane)];
}

// The planes of N fragments of one triangle.
template <int N>
class TrianglePlanes {
  public:
    TrianglePlanes(const TileBuffer& tile, std::int32_t triangle)
        : data_(planes_of<N>(tile, triangle)) {}

    typename Lanes<N>::Float value(int j) const { return data_[j * N]; }

  private:
    const float* data_;
};

// The planes of N fragments, each of a triangle of one of two groups, which begin with triangle
// number first and second: lane is its place in the first, or N more than its place in the second.
template <int N>
class GroupPlanes {
    using I = typename Lanes<N>::Int;

  public:
    GroupPlanes(const TileBuffer& tile, std::int32_t first, std::int32_t second, const I& lane)
        : first_(planes_of<N>(tile, first)), second_(planes_of<N>(tile, second)), lane_(lane) {}

    typename Lanes<N>::Float value(int j) const {
        return lookup(first_ + j * N, second_ + j * N, lane_);
    }

  private:
    const float* first_;
    const float* second_;
    I lane_;
};

// Sets up the planes of the triangles that own fragments; N is the frame's lanes.
void set_up_planes(const Frame& frame, TileBuffer& tile);

}  // namespace glint
