// The planes of one triangle of any size, one at a time.
#pragma once

#include "framework/raster/tile_planes.hpp"

#include <cstddef>

namespace glint {

// Writes the plane_values() of a triangle, in floats that lie `lanes` apart, from its exact edges
// and in double: for triangles whose area 32 bits do not hold, and pieces of clipped ones. The
// anchor is the corner of the tile where S is smallest, or the one opposite where that lies beyond
// the triangle's horizon; first is always of the nearest corner.
void set_up_large_planes(const Frame& frame, const TileBuffer& tile, const ScreenTriangle& triangle,
                         const Shader& shader, std::size_t lanes, float* planes);

}  // namespace glint
