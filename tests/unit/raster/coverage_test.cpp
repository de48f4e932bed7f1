// Both rasterizers against exact arithmetic, on the oracle's random and adversarial cases.
#include "framework/raster/coverage.hpp"

#include "framework/math/dispatch.hpp"
#include "tests/oracle/check.hpp"

#include <doctest/doctest.h>

namespace glint {
namespace {

oracle::Rasterizer with(Rasterizer rasterizer, int lanes) {
    return [=](std::span<const oracle::Triangle> triangles, int width, int height, int samples,
               const oracle::Emit& emit) {
        std::vector<std::array<glm::ivec2, 3>> corners;
        for (const oracle::Triangle& t : triangles) {
            corners.push_back({glm::ivec2(t[0].x, t[0].y), glm::ivec2(t[1].x, t[1].y),
                               glm::ivec2(t[2].x, t[2].y)});
        }
        const Settings settings{.rasterizer = rasterizer, .lanes = lanes, .samples = samples};
        find_coverage(corners, width, height, settings, emit);
    };
}

void expect_exact(const oracle::Rasterizer& rasterizer, int cases) {
    const oracle::Verdict verdict = oracle::check_all(rasterizer, cases);
    CHECK(verdict.cases >= cases);
    INFO(verdict.report);
    CHECK(verdict.failures == 0);
}

#ifdef EMULATOR
constexpr int many = 3000;
#else
constexpr int many = 100000;
#endif

TEST_CASE("the scanline rasterizer covers exactly what the top-left rule says") {
    expect_exact(with(Rasterizer::scanline, 1), many);
}

TEST_CASE("the tile rasterizer covers exactly what the top-left rule says") {
    expect_exact(with(Rasterizer::tiles, max_lanes), many);
}

TEST_CASE("and with fewer lanes") {
    for (const int lanes : {1, 4, 8}) {
        if (has_lanes(lanes)) {
            expect_exact(with(Rasterizer::tiles, lanes), many / 10);
        }
    }
}

}  // namespace
}  // namespace glint
