#include "framework/geometry/shapes.hpp"
#include "framework/geometry/surface_grid.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace glint {
namespace {

struct Ball {
    std::vector<glm::dvec3> points;  // on the unit sphere
    std::vector<glm::uvec3> triangles;
};

// Twelve corners of three golden rectangles.
Ball icosahedron() {
    constexpr double g = std::numbers::phi;
    Ball ball;
    ball.points = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                   {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    for (glm::dvec3& p : ball.points) {
        p = normalize(p);
    }
    ball.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                      {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                      {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                      {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    return ball;
}

// Each triangle becomes four, the new corners lifted to the sphere.
Ball subdivide(const Ball& coarse) {
    Ball fine{.points = coarse.points, .triangles = {}};
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
        const auto next = static_cast<std::uint32_t>(fine.points.size());
        const auto [at, is_new] = middles.try_emplace(std::minmax(a, b), next);
        if (is_new) {
            fine.points.push_back(normalize(coarse.points[a] + coarse.points[b]));
        }
        return at->second;
    };
    for (const glm::uvec3& t : coarse.triangles) {
        const glm::uvec3 m(middle(t.x, t.y), middle(t.y, t.z), middle(t.z, t.x));
        fine.triangles.insert(fine.triangles.end(),
                              {{t.x, m.x, m.z}, {m.x, t.y, m.y}, {m.z, m.y, t.z}, m});
    }
    return fine;
}

bool is_pole(const glm::dvec3& p) {
    return p.x == 0.0 && p.z == 0.0;
}

glm::dvec2 longitude_latitude(const glm::dvec3& p) {
    const double u = std::atan2(p.x, p.z) / (2.0 * std::numbers::pi) + 0.5;
    return {u < 1.0 ? u : 0.0, std::asin(std::clamp(p.y, -1.0, 1.0)) / std::numbers::pi + 0.5};
}

// u on one side of the seam for all three corners, and between the others' at a pole.
void join_longitudes(const glm::dvec3 (&corner)[3], glm::dvec2 (&uv)[3]) {
    double low = 1.0;
    double high = 0.0;
    for (int i = 0; i < 3; ++i) {
        if (!is_pole(corner[i])) {
            low = std::min(low, uv[i].x);
            high = std::max(high, uv[i].x);
        }
    }
    const bool crosses = high - low > 0.5;
    double sum = 0.0;
    for (int i = 0; i < 3; ++i) {
        uv[i].x += crosses && uv[i].x < 0.5 ? 1.0 : 0.0;
        sum += is_pole(corner[i]) ? 0.0 : uv[i].x;
    }
    for (int i = 0; i < 3; ++i) {
        uv[i].x = is_pole(corner[i]) ? 0.5 * sum : uv[i].x;
    }
}

}  // namespace

Mesh icosphere(float radius, int subdivisions) {
    check_length("icosphere: radius", radius);
    check_count("icosphere: subdivisions", subdivisions, 0, 8);
    Ball ball = icosahedron();
    for (int i = 0; i < subdivisions; ++i) {
        ball = subdivide(ball);
    }
    Mesh mesh;
    std::map<std::pair<std::uint32_t, double>, std::uint32_t> numbers;  // of a point and its u
    for (const glm::uvec3& t : ball.triangles) {
        const glm::dvec3 corner[] = {ball.points[t.x], ball.points[t.y], ball.points[t.z]};
        glm::dvec2 uv[] = {longitude_latitude(corner[0]), longitude_latitude(corner[1]),
                           longitude_latitude(corner[2])};
        join_longitudes(corner, uv);
        glm::uvec3 triangle;
        for (int i = 0; i < 3; ++i) {
            const auto next = static_cast<std::uint32_t>(mesh.positions.size());
            const auto [at, is_new] = numbers.try_emplace({t[i], uv[i].x}, next);
            if (is_new) {
                mesh.positions.emplace_back(static_cast<double>(radius) * corner[i]);
                mesh.normals.emplace_back(corner[i]);
                mesh.uvs.emplace_back(uv[i]);
            }
            triangle[i] = at->second;
        }
        mesh.triangles.push_back(triangle);
    }
    return mesh;
}

}  // namespace glint
