// The Utah teapot. Numbers: M. Newell, The Utilization of Procedure Models in Digital Image
// Synthesis, PhD thesis, University of Utah 1975; bottom: F. Crow, The Origins of the Teapot,
// IEEE Computer Graphics and Applications 7(1), 1987. His z is up, ours is y.
#include "framework/geometry/bezier_patch.hpp"
#include "framework/geometry/shapes.hpp"
#include "framework/geometry/surface_grid.hpp"

#include <span>

namespace glint {
namespace {

// Body and lid are turned on a lathe: control points of their profiles, upwards. A quarter of a
// circle of radius 1 is the cubic (1, 0) (1, k) (k, 1) (0, 1), and Newell took k = 0.56.
struct LathePoint {
    double radius, height;
    double k = 0.56;
};
constexpr LathePoint body[] = {{0, 0},        {1.425, 0}, {1.5, 0.075},      {1.5, 0.15},
                               {1.5, 0.225},  {2, 0.45},  {2, 0.9},          {2, 1.35},
                               {1.75, 1.875}, {1.5, 2.4}, {1.4375, 2.53125}, {1.3375, 2.53125},
                               {1.4, 2.4}};
constexpr LathePoint lid[] = {{1.3, 2.4}, {1.3, 2.55},         {0.4, 2.55}, {0.2, 2.7},
                              {0, 2.85},  {0.8, 3.15, 0.5625}, {0, 3.15}};

// Handle and spout are tubes, mirrored at z = 0: where a cross-section meets that plane, first at
// the inner and then at the outer bend, and how far its control points stand off the plane.
struct TubeSection {
    glm::dvec2 inner, outer;
    double half_width;
};
constexpr TubeSection handle[] = {
    {{-1.6, 2.025}, {-1.5, 2.25}, 0.3}, {{-2.3, 2.025}, {-2.5, 2.25}, 0.3},
    {{-2.7, 2.025}, {-3, 2.25}, 0.3},   {{-2.7, 1.8}, {-3, 1.8}, 0.3},
    {{-2.7, 1.575}, {-3, 1.35}, 0.3},   {{-2.5, 1.125}, {-2.65, 0.9375}, 0.3},
    {{-2, 0.9}, {-1.9, 0.6}, 0.3}};
constexpr TubeSection spout[] = {
    {{1.7, 1.425}, {1.7, 0.6}, 0.66},       {{2.6, 1.425}, {3.1, 0.825}, 0.66},
    {{2.3, 2.1}, {2.4, 2.025}, 0.25},       {{2.7, 2.4}, {3.3, 2.4}, 0.25},
    {{2.8, 2.475}, {3.525, 2.49375}, 0.25}, {{2.9, 2.475}, {3.45, 2.5125}, 0.15},
    {{2.8, 2.4}, {3.2, 2.4}, 0.15}};

using Row = std::array<glm::dvec3, 4>;

Row quarter_circle(const LathePoint& p, int quarter) {
    const glm::dvec2 a = turn(quarter, 4);
    const glm::dvec3 from = p.radius * glm::dvec3(-a.y, 0.0, -a.x);
    const glm::dvec3 to = p.radius * glm::dvec3(-a.x, 0.0, a.y);
    const glm::dvec3 height(0.0, p.height, 0.0);
    return {from + height, from + p.k * to + height, p.k * from + to + height, to + height};
}

Row half_section(const TubeSection& s, int half) {
    const auto at = [](const glm::dvec2& xy, double z) { return glm::dvec3(xy, z); };
    if (half == 0) {
        return {at(s.inner, 0), at(s.inner, s.half_width), at(s.outer, s.half_width),
                at(s.outer, 0)};
    }
    return {at(s.outer, 0), at(s.outer, -s.half_width), at(s.inner, -s.half_width), at(s.inner, 0)};
}

// The patches of one part: round it in steps, then along its rows, four to a patch with the last
// shared by the next.
template <class Section, class MakeRow>
TeapotPatch* add_part(TeapotPatch* to, std::span<const Section> rows, int around, MakeRow make) {
    const std::size_t along = rows.size() / 3;
    const glm::dvec2 size(1.0 / around, 1.0 / static_cast<double>(along));
    for (std::size_t k = 0; k < along; ++k) {
        for (int i = 0; i < around; ++i) {
            BicubicPatch patch;
            for (std::size_t row = 0; row < 4; ++row) {
                patch.control[row] = make(rows[3 * k + row], i);
            }
            *to++ = {.patch = patch,
                     .uv = glm::dvec2(i, static_cast<double>(k)) * size,
                     .uv_size = size,
                     .first_row_is_point = patch.control[0][0] == patch.control[0][3],
                     .last_row_is_point = patch.control[3][0] == patch.control[3][3]};
        }
    }
    return to;
}

}  // namespace

std::array<TeapotPatch, 32> teapot_patches() {
    std::array<TeapotPatch, 32> patches;
    TeapotPatch* to = patches.data();
    to = add_part(to, std::span<const LathePoint>(body), 4, quarter_circle);
    to = add_part(to, std::span<const LathePoint>(lid), 4, quarter_circle);
    to = add_part(to, std::span<const TubeSection>(handle), 2, half_section);
    add_part(to, std::span<const TubeSection>(spout), 2, half_section);
    return patches;
}

Mesh teapot(int steps) {
    check_count("teapot: steps", steps, 2, 256);
    Mesh mesh;
    for (const TeapotPatch& part : teapot_patches()) {
        const Grid grid{steps, steps, part.first_row_is_point, part.last_row_is_point};
        append_grid(mesh, grid, [&](double column, double row) {
            const glm::dvec2 uv(column / steps, row / steps);
            return SurfacePoint{.position = point(part.patch, uv.x, uv.y),
                                .normal = normal(part.patch, uv.x, uv.y),
                                .uv = part.uv + part.uv_size * uv};
        });
    }
    return mesh;
}

}  // namespace glint
