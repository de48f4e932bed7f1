// Bicubic Bezier patches, and the 32 that Newell's teapot is made of.
#pragma once

#include "framework/math/vec.hpp"

#include <array>

namespace glint {

// control[row][column]; u runs along a row, v from row to row, both 0..1. The outside is where
// dS/du x dS/dv points.
struct BicubicPatch {
    std::array<std::array<glm::dvec3, 4>, 4> control;
};

glm::dvec3 point(const BicubicPatch& patch, double u, double v);

// Unit normal from the derivatives. Where the first or the last row is one point dS/du vanishes;
// there it is the limit along u = constant.
glm::dvec3 normal(const BicubicPatch& patch, double u, double v);

struct TeapotPatch {
    BicubicPatch patch;
    glm::dvec2 uv, uv_size;  // its part of the texture of body, lid, handle or spout
    bool first_row_is_point, last_row_is_point;
};

// Body 16 (rim, belly, bottom), lid 8, handle 4, spout 4; all outside out.
std::array<TeapotPatch, 32> teapot_patches();

}  // namespace glint
