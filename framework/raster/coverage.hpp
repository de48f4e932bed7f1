// What triangles cover, each for itself: for holding the rasterizers against an oracle.
#pragma once

#include "framework/raster/pipeline.hpp"

#include <array>
#include <functional>
#include <span>

namespace glint {

// Called for pixels x_begin <= x < x_end of row y, whose sample number s the triangle covers.
using CoverageSink = std::function<void(int s, int triangle, int y, int x_begin, int x_end)>;

// Triangles in 24.8 fixed-point pixels within the guard band; of the settings the rasterizer, the
// lanes and the samples count. Runs come triangle by triangle, in pieces, each row from the left.
void find_coverage(std::span<const std::array<glm::ivec2, 3>> triangles, int width, int height,
                   const Settings& settings, const CoverageSink& sink);

}  // namespace glint
