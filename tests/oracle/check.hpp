// Holds a rasterizer against the oracle, and says in words and a picture where it is wrong.
#pragma once

#include "tests/oracle/cases.hpp"

#include <functional>
#include <string>

namespace glint::oracle {

// Says that a triangle covers this sample of the pixels x_begin <= x < x_end of row y.
using Emit = std::function<void(int sample, int triangle, int y, int x_begin, int x_end)>;

// Emits what is covered, each pixel once for each triangle and sample, in any order and in pieces
// of any length; one that ends where it begins, or before, is nothing. Samples are numbered as in
// sample_positions().
using Rasterizer = std::function<void(std::span<const Triangle> triangles, int width, int height,
                                      int samples, const Emit& emit)>;

// What is wrong with the rasterizer's answer to the case; empty where nothing is. A picture shows
// the first wrong pixel's neighbourhood: '#' right, '!' extra, '?' missing, '.' none.
std::string check(const Rasterizer& rasterizer, const Case& c);

struct Verdict {
    int cases = 0;
    int failures = 0;  // cases that are wrong
    std::vector<std::string_view> failing_kinds;
    std::string report;  // the first failure of each failing kind
};

// Tries at least so many cases, as many of each kind, from seed on.
Verdict check_all(const Rasterizer& rasterizer, int cases, std::uint64_t seed = 0);

}  // namespace glint::oracle
