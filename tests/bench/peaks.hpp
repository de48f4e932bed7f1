// What the machine can do at most, measured in the same run as all else.
#pragma once

#include "tests/bench/glint_frames.hpp"

#include <functional>

namespace glint {

// Each call does the same amount of work on one thread, for time_in_turns().
struct Peak {
    std::function<void()> work;
    double amount;  // of a call: floating-point operations, bytes, fragments
};

// Multiply-adds of floats (two operations each) in registers of that many lanes.
Peak fma_peak(int lanes);

// Bytes written to a block larger than the caches.
Peak write_peak();

// Lesson 15's model over rows of full registers, encoded to sRGB and stored: the same fragments
// with neither triangles nor edges, varyings a linear function of the column.
Peak straight_kernel(const BenchShader& shader, const glm::vec3& eye, int lanes);

}  // namespace glint
