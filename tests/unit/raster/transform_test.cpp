#include "framework/raster/transform.hpp"

#include "framework/scene/camera.hpp"
#include "tests/oracle/random.hpp"
#include "tests/unit/raster/drawing.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <limits>

namespace glint {
namespace {

using oracle::Random;

VertexBuffer transformed(const std::vector<glm::vec3>& positions, const View& view, int lanes) {
    VertexBuffer out(positions.size());
    transform(positions, view, lanes, 0, positions.size(), out);
    return out;
}

std::vector<glm::vec3> many_positions(Random& random, int count) {
    std::vector<glm::vec3> positions;
    for (int i = 0; i < count; ++i) {
        const double size = std::pow(10.0, random.real(-3, 4));
        positions.emplace_back(random.real(-size, size), random.real(-size, size),
                               random.real(-size, size));
    }
    positions[0].x = std::numeric_limits<float>::quiet_NaN();
    positions[1].y = std::numeric_limits<float>::infinity();
    positions[2].z = -std::numeric_limits<float>::infinity();
    positions[3] = {0, 0, 0};
    return positions;
}

TEST_CASE("lanes transform to the same bits as one lane") {
    Random random(1);
    const Camera camera{.eye = {0, 0, 0}, .target = {1, 2, 3}, .near = 0.01F};
    const View view{clip_from_world(camera, 1.7F), 1700, 1000};
    const auto positions = many_positions(random, 4003);
    const VertexBuffer one = transformed(positions, view, 1);
    for (const int lanes : all_lanes()) {
        CAPTURE(lanes);
        const VertexBuffer many = transformed(positions, view, lanes);
        int differ = 0;
        int placed = 0;
        for (std::size_t i = 0; i < positions.size(); ++i) {
            differ += many[i].x != one[i].x ? 1 : 0;
            if (one[i].x != needs_clipping) {
                ++placed;
                differ += many[i].y != one[i].y || many[i].z != one[i].z ||
                                  many[i].inverse_w != one[i].inverse_w
                              ? 1
                              : 0;
            }
        }
        CHECK(differ == 0);
        CHECK(placed > 500);
    }
}

TEST_CASE("window positions are the exact ones to 1/256 pixel") {
    Random random(2);
    const Camera camera{.eye = {1, 2, 3}, .target = {0, 0, 0}, .near = 0.5F, .far = 100};
    const View view{clip_from_world(camera, 640.0F / 480.0F), 640, 480};
    const auto positions = many_positions(random, 3000);
    const VertexBuffer out = transformed(positions, view, max_lanes);
    int placed = 0;
    int wrong = 0;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const glm::dvec3 p(positions[i]);
        const glm::dvec4 clip = clip_position(view.clip_from_world, p.x, p.y, p.z);
        const WindowPosition<double> exact = window_position(clip, view);
        const double far = std::max(std::abs(exact.x), std::abs(exact.y));
        if (out[i].x == needs_clipping) {
            // Not in front, or outside, give or take a rounding.
            wrong += clip.w > 0 && clip.z < clip.w * (1 - 1e-5) && far < 0.999 * guard_band;
            continue;
        }
        ++placed;
        const double bound = 0.5 / 256 + 1e-6 * (far + 640) * (1 + length(p) / clip.w);
        wrong += std::abs(out[i].x / 256.0 - exact.x) > bound;
        wrong += std::abs(out[i].y / 256.0 - exact.y) > bound;
        wrong += std::abs(out[i].z - exact.z) > 1e-6 * (1 + length(p) / clip.w);
    }
    CHECK(wrong == 0);
    CHECK(placed > 500);
}

TEST_CASE("only the named part is transformed") {
    const View view = window_view(64, 64);
    const std::vector<glm::vec3> positions(40, glm::vec3(3, 5, 0.5F));
    for (const int lanes : all_lanes()) {
        VertexBuffer out;
        out.resize(positions.size());
        transform(positions, view, lanes, 7, 31, out);
        for (std::size_t i = 0; i < positions.size(); ++i) {
            const bool inside = i >= 7 && i < 31;
            CHECK(out[i].x == (inside ? 3 * subpixel_one : 0));
            CHECK(out[i].y == (inside ? 5 * subpixel_one : 0));
            CHECK(out[i].z == (inside ? 0.5F : 0.0F));
        }
    }
}

}  // namespace
}  // namespace glint
