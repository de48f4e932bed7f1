// What the shapes are built with: grids of samples of a parametric surface. Not for users of
// meshes, they want shapes.hpp.
#pragma once

#include "framework/geometry/mesh.hpp"

#include <functional>

namespace glint {

struct SurfacePoint {
    glm::dvec3 position;
    glm::dvec3 normal;  // unit length, outwards
    glm::dvec2 uv;
};

// columns x rows cells. A row of vertices that all fall on one point (a pole) has one vertex a
// cell, sampled in the middle of the cell, so that its normal and u fit its only triangle.
struct Grid {
    int columns = 0;
    int rows = 0;
    bool first_row_is_point = false;
    bool last_row_is_point = false;
};

// Adds the surface to the mesh, two triangles a cell and one at a pole. at(column, row) is called
// with 0..columns and 0..rows; seen from outside columns run to the right and rows run up.
using Surface = std::function<SurfacePoint(double column, double row)>;
void append_grid(Mesh& mesh, const Grid& grid, const Surface& at);

// Cosine and sine of the i-th of n equal parts of a full turn, 0 <= i <= n, n < 2^28. Bit for bit
// the same after a full turn, mirrored at the axes and diagonals, 0 and 1 where they should be.
glm::dvec2 turn(double i, int n);

// Parameters are checked by these; the Error says "shape: what must be low to high, not value".
// A length is 1e-6 to 1e6, so that no float overflows and no triangle shrinks to nothing.
void check_count(const char* what, int value, int low, int high);
void check_length(const char* what, float value);

inline constexpr int max_steps = 4096;  // in one direction

}  // namespace glint
