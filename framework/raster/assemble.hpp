// All triangles of a mesh in window space, in submission order: stages 1 and 2, for who needs no
// speed.
#pragma once

#include "framework/raster/pipeline.hpp"

#include <vector>

namespace glint {

struct Mesh;

struct Assembly {
    std::vector<ScreenTriangle> triangles;  // clipped ones in pieces
    std::int64_t not_finite = 0;            // dropped
};

Assembly assemble(const Mesh& mesh, const View& view);

}  // namespace glint
