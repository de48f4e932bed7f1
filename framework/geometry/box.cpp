// Plane, box and rounded box: shapes with flat faces.
#include "framework/geometry/shapes.hpp"
#include "framework/geometry/surface_grid.hpp"
#include "framework/math/error.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glint {
namespace {

// A face of a box as who looks at it sees it; right x up points outwards.
struct Face {
    glm::dvec3 right, up;
    glm::dvec3 out() const { return cross(right, up); }
};
constexpr Face faces[] = {{.right = {0, 0, -1}, .up = {0, 1, 0}},
                          {{0, 0, 1}, {0, 1, 0}},
                          {{1, 0, 0}, {0, 0, -1}},
                          {{1, 0, 0}, {0, 0, 1}},
                          {{1, 0, 0}, {0, 1, 0}},
                          {{-1, 0, 0}, {0, 1, 0}}};

void append_rectangle(Mesh& mesh, const Face& face, const glm::dvec3& half, int columns, int rows) {
    append_grid(mesh, {.columns = columns, .rows = rows}, [&](double column, double row) {
        const glm::dvec2 uv(column / columns, row / rows);
        const glm::dvec3 at =
            face.out() + (2.0 * uv.x - 1.0) * face.right + (2.0 * uv.y - 1.0) * face.up;
        return SurfacePoint{.position = at * half, .normal = face.out(), .uv = uv};
    });
}

void check_size(const char* what, const glm::vec3& size) {
    for (int i = 0; i < 3; ++i) {
        check_length(what, size[i]);
    }
}

// One coordinate along a rounded face: a curved part, the flat part, a curved part.
struct Across {
    double side;   // -1 or 1: which curved part
    double slope;  // tangent of the angle that the normal leans by
    double place;  // 0..1 by length along the surface
};

Across across(double column, int steps, double radius, double flat_half) {
    const double side = column <= steps ? -1.0 : 1.0;
    const double from_flat = column <= steps ? steps - column : column - steps - 1;
    const double angle = from_flat / steps * (std::numbers::pi / 4.0);
    // exactly 1 where faces meet
    const double slope = from_flat == steps ? 1.0 : std::tan(angle);
    const double half_length = flat_half + radius * (std::numbers::pi / 4.0);
    const double distance = flat_half + radius * angle;
    return {side, side * slope, 0.5 + 0.5 * side * distance / half_length};
}

// Length 1, with the same rounding whatever the order of the coordinates: neighbouring faces
// compute the points that they share with different ones.
glm::dvec3 unit(const glm::dvec3& v) {
    const glm::dvec3 s = v * v;
    const double middle = std::max(std::min(s.x, s.y), std::min(std::max(s.x, s.y), s.z));
    return v / std::sqrt(std::min({s.x, s.y, s.z}) + middle + std::max({s.x, s.y, s.z}));
}

}  // namespace

Mesh plane(float width, float depth, int columns, int rows) {
    check_length("plane: width", width);
    check_length("plane: depth", depth);
    check_count("plane: columns", columns, 1, max_steps);
    check_count("plane: rows", rows, 1, max_steps);
    Mesh mesh;
    const Face upwards{.right = {1, 0, 0}, .up = {0, 0, -1}};
    append_rectangle(mesh, upwards, {0.5 * width, 0.0, 0.5 * depth}, columns, rows);
    return mesh;
}

Mesh box(const glm::vec3& size) {
    check_size("box: size", size);
    Mesh mesh;
    for (const Face& face : faces) {
        append_rectangle(mesh, face, 0.5 * glm::dvec3(size), 1, 1);
    }
    return mesh;
}

Mesh rounded_box(const glm::vec3& size, float radius, int steps) {
    check_size("rounded box: size", size);
    check_length("rounded box: radius", radius);
    check_count("rounded box: steps", steps, 1, 1024);
    if (2.0F * radius >= std::min({size.x, size.y, size.z})) {
        throw Error("rounded box: radius must be less than half the smallest side");
    }
    const glm::dvec3 core = 0.5 * glm::dvec3(size) - static_cast<double>(radius);
    const int cells = 2 * steps + 1;
    Mesh mesh;
    for (const Face& face : faces) {
        append_grid(mesh, {.columns = cells, .rows = cells}, [&](double column, double row) {
            const Across x = across(column, steps, radius, std::abs(dot(face.right, core)));
            const Across y = across(row, steps, radius, std::abs(dot(face.up, core)));
            const glm::dvec3 normal = unit(face.out() + x.slope * face.right + y.slope * face.up);
            const glm::dvec3 corner = face.out() + x.side * face.right + y.side * face.up;
            return SurfacePoint{.position = corner * core + static_cast<double>(radius) * normal,
                                .normal = normal,
                                .uv = {x.place, y.place}};
        });
    }
    return mesh;
}

}  // namespace glint
