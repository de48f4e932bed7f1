// A plane to the horizon: perspective-correct interpolation against the points at which the pixels'
// rays meet the plane, in double.
#include "framework/raster/plug.hpp"
#include "framework/raster/tile.hpp"
#include "framework/geometry/shapes.hpp"
#include "tests/unit/raster/drawing.hpp"
#include "tests/unit/raster/rays.hpp"

#include <doctest/doctest.h>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace glint {
namespace {

constexpr int width = 200;
constexpr int height = 150;

// Vertices are snapped to 1/256 pixel, so each is off by sqrt(2)/512 pixel or less. A point between
// them is then off by a mean of their errors, however far away it is.
constexpr double snapping = 1.4143 / 512;

// Positions are sums of vertices' coordinates of up to 1000 with a few roundings: an error that
// shows where the plane is near, where a pixel is small. Tiles have it as at their nearest point.
constexpr double half_side = 1000;
constexpr double rounding = 4 * 0x1p-24 * half_side;

struct Errors {
    double position = 0, depth = 0;  // pixels
    double to_bound = 0;             // position, by what is allowed there
    double plane = 0;                // distance from it
    int pixels = 0;
    double nearest_horizon = 1e9;  // pixels
};

Errors errors_of(const Camera& camera, const Mesh& mesh, const Settings& settings) {
    const View view{clip_from_world(camera, static_cast<float>(width) / height), width, height};
    const Rays rays(camera, width, height);
    const Drawn d = draw(mesh, view, plug(show_position), settings);
    Errors e;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const glm::dvec3 direction = rays.direction(x + 0.5, y + 0.5);
            // How many pixels up the ray would miss the plane.
            const double per_row = rays.direction(x + 0.5, y - 0.5).y - direction.y;
            const double below_horizon = -direction.y / per_row;
            const double distance = -rays.origin.y / direction.y;
            const glm::dvec3 hit = rays.origin + distance * direction;
            const bool on_mesh = std::max(std::abs(hit.x), std::abs(hit.z)) < 0.99 * half_side;
            if (below_horizon < 1 || distance < double{camera.near} * 1.001 || !on_mesh) {
                continue;
            }
            ++e.pixels;
            e.nearest_horizon = std::min(e.nearest_horizon, below_horizon);
            const glm::dvec3 shown(d.linear(x, y));
            const glm::dvec2 at(rays.project(shown));
            const double off = length(at - glm::dvec2(x + 0.5, y + 0.5));
            const double pixels_a_unit = (below_horizon + tile_size) / rays.origin.y;
            e.position = std::max(e.position, off);
            e.to_bound = std::max(e.to_bound, off / (snapping + rounding * pixels_a_unit));
            e.plane = std::max(e.plane, std::abs(shown.y));
            // Depth falls with 1 / distance, which is linear in the window.
            const double drawn = distance_of_depth(camera, double{d.depth(x, y)});
            const double rows = below_horizon * (distance / drawn - 1);
            e.depth = std::max(e.depth, std::abs(rows));
        }
    }
    return e;
}

void check_plane(const Camera& camera, const Mesh& mesh) {
    for (const Settings& settings : both_rasterizers()) {
        CAPTURE(words(settings));
        const Errors e = errors_of(camera, mesh, settings);
        CHECK(e.pixels > 5000);
        CHECK(e.nearest_horizon < 2);
        CHECK(e.to_bound < 1);
        CHECK(e.position < 0.02);
        CHECK(e.depth < 1.1 * snapping);
        CHECK(e.plane < rounding);
    }
}

TEST_CASE("a plane of two triangles is right to the last pixel before the horizon") {
    check_plane({.eye = {0.3F, 1, 0.1F},
                 .target = {5, 0.5F, -7},
                 .fov_degrees = 60,
                 .near = 0.1F,
                 .far = 1e4F},
                plane(2000, 2000, 1, 1));
}

TEST_CASE("so is a plane of many triangles, and one that leans") {
    const Camera camera{.eye = {-20, 1.5F, 30},
                        .target = {5, 0, -7},
                        .up = {0.4F, 1, 0.1F},
                        .fov_degrees = 75,
                        .near = 0.5F,
                        .far = 1e4F};
    check_plane(camera, plane(2000, 2000, 1, 1));
    check_plane(camera, plane(2000, 2000, 60, 40));
}

}  // namespace
}  // namespace glint
