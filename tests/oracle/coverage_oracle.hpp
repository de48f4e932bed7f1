// Which samples a triangle covers, by exact integer arithmetic: what every rasterizer is held
// against. It is not a rasterizer: it knows no tiles, no lanes and no steps.
//
// Origin top-left, y down. A sample is covered by the top-left rule (Direct3D 11.3 Functional
// Specification, 15.14 "Triangle Rasterization Rules"): strictly inside, or on an edge that is a
// left edge or an exactly horizontal top edge; a vertex belongs to both its edges. In other words:
// the sample, moved right by an infinitesimal and down by a far smaller one, is strictly inside.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace glint::oracle {

// In 1/256 px. No coordinate is beyond +-16384 px, so that every product below fits 64 bits.
inline constexpr int units_per_pixel = 256;
inline constexpr int guard_band = 16384 * units_per_pixel;

struct Point {
    std::int32_t x, y;
    friend bool operator==(const Point&, const Point&) = default;
};

using Triangle = std::array<Point, 3>;  // winds either way; zero area covers nothing

// Twice the signed area of a, b, c: positive where they go clockwise as seen on the screen.
std::int64_t doubled_area(Point a, Point b, Point c);

// The definition, word for word.
bool covers(const Triangle& triangle, Point sample);

// Where the samples of a pixel lie, from its top-left corner: the standard Direct3D positions of
// 1, 2, 4, 8 or 16 samples, which Vulkan numbers in the same order ("standardSampleLocations").
std::span<const Point> sample_positions(int samples);

struct Run {  // pixels x_begin <= x < x_end of row y
    int y, x_begin, x_end;
    friend bool operator==(const Run&, const Run&) = default;
};

// Appends the longest runs of the pixels 0 <= x < width, 0 <= y < height whose sample at position
// lies inside the closed polygon: by the top-left rule, and even-odd where it crosses itself.
// Rows from the top, each from the left. For a triangle it is covers() at every pixel, only fast.
void append_runs(std::span<const Point> polygon, Point position, int width, int height,
                 std::vector<Run>& runs);

}  // namespace glint::oracle
