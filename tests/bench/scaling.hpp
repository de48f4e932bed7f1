// How the cost of a frame grows with what it holds.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace glint {

struct ScalePoint {
    double size;  // of what grows
    double ms;    // least of the rounds
};

struct Scale {
    std::string name;  // what grows
    std::string unit;
    std::vector<ScalePoint> points{};  // at least two, by size

    // By how much doubling the size multiplies the time, as an exponent: 1 is proportional. Of a
    // straight line through all points, on logarithmic axes, and between point i and the next.
    double slope() const;
    double slope(std::size_t i) const;
};

struct Memory {
    double bytes_a_triangle = 0;  // resident, the mesh included
    double bytes_a_pixel = 0;     // resident, the picture included
    double peak_large_mb = 0;     // with 10 M triangles, at 7680x4320
    double growth_mb = 0;         // over 1000 frames, after the first ten
};

struct ScalingResult {
    int rounds = 0;  // of which the least is taken
    std::vector<Scale> scales{};
    Memory memory{};
};

// Tells about its progress on the error stream.
ScalingResult run_scaling(int rounds);

std::string table(const ScalingResult& result);
nlohmann::json to_json(const ScalingResult& result);

}  // namespace glint
