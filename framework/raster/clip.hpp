// Stage 2, the rare case: triangles that cross the near plane or leave the guard band.
#pragma once

#include "framework/raster/pipeline.hpp"

#include <glm/vec3.hpp>

#include <vector>

namespace glint {

struct Mesh;

// Appends to out the pieces of mesh triangle number source inside near plane and guard band: none
// where it lies outside, up to 7 otherwise, in an order that depends on the triangle alone.
// Homogeneous clipping (Sutherland and Hodgman 1974; Blinn and Newell 1978) in double. A clipped
// edge is cut the same way from both its sides, so neighbours stay joined.
// Returns false, appending nothing, where a vertex is not finite.
bool clip_triangle(const Mesh& mesh, std::uint32_t source, const View& view,
                   const VertexBuffer& vertices, std::vector<ScreenTriangle>& out);

}  // namespace glint
