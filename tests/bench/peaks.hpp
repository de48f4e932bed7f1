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

// Lesson 15's model over rows of full registers, encoded to sRGB and stored: fragments as of a
// round thing that fills the picture, with neither triangles nor edges.
Peak straight_kernel(const BenchShader& shader, int lanes);

}  // namespace glint
