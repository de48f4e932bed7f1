#include "framework/geometry/surface_grid.hpp"

#include "framework/math/error.hpp"

#include <cmath>
#include <numbers>
#include <sstream>

namespace glint {
namespace {

// Where each row of vertices begins.
class VertexNumbers {
  public:
    VertexNumbers(const Grid& grid, std::size_t first)
        : grid_(grid), first_(static_cast<std::uint32_t>(first)) {}

    bool is_point(int row) const {
        return (row == 0 && grid_.first_row_is_point) ||
               (row == grid_.rows && grid_.last_row_is_point);
    }
    int in_row(int row) const { return is_point(row) ? grid_.columns : grid_.columns + 1; }
    std::uint32_t operator()(int column, int row) const {
        const int width = grid_.columns + 1;
        const int missing = row > 0 && grid_.first_row_is_point ? 1 : 0;
        return first_ + static_cast<std::uint32_t>(row * width - missing + column);
    }

  private:
    Grid grid_;
    std::uint32_t first_;
};

void append_point(Mesh& mesh, const SurfacePoint& p) {
    mesh.positions.emplace_back(p.position);
    mesh.normals.emplace_back(p.normal);
    mesh.uvs.emplace_back(p.uv);
}

}  // namespace

void append_grid(Mesh& mesh, const Grid& grid, const Surface& at) {
    const VertexNumbers vertex(grid, mesh.positions.size());
    for (int row = 0; row <= grid.rows; ++row) {
        const double offset = vertex.is_point(row) ? 0.5 : 0.0;
        for (int column = 0; column < vertex.in_row(row); ++column) {
            append_point(mesh, at(column + offset, row));
        }
    }
    for (int row = 0; row < grid.rows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
            const std::uint32_t low = vertex(column, row);
            const std::uint32_t high = vertex(column, row + 1);
            if (vertex.is_point(row + 1)) {
                mesh.triangles.emplace_back(low, low + 1, high);
                continue;
            }
            mesh.triangles.emplace_back(low, high + 1, high);
            if (!vertex.is_point(row)) {
                mesh.triangles.emplace_back(low, low + 1, high + 1);
            }
        }
    }
}

glm::dvec2 turn(double i, int n) {
    const int quarter = static_cast<int>(4.0 * i / n);
    const double rest = 4.0 * i - static_cast<double>(quarter) * n;  // of n in this quarter
    const bool second_half = 2.0 * rest > n;
    const double angle = (second_half ? n - rest : rest) / n * (std::numbers::pi / 2.0);
    glm::dvec2 a(std::cos(angle), std::sin(angle));
    if (second_half) {
        a = {a.y, a.x};
    }
    switch (quarter % 4) {
        case 0:
            return a;
        case 1:
            return {-a.y, a.x};
        case 2:
            return -a;
        default:
            return {a.y, -a.x};
    }
}

void check_count(const char* what, int value, int low, int high) {
    if (value < low || value > high) {
        std::ostringstream text;
        text << what << " must be " << low << " to " << high << ", not " << value;
        throw Error(text.str());
    }
}

void check_length(const char* what, float value) {
    if (!(value >= 1e-6F && value <= 1e6F)) {
        std::ostringstream text;
        text << what << " must be 1e-6 to 1e6, not " << value;
        throw Error(text.str());
    }
}

}  // namespace glint
