// Everything about one pixel.
#pragma once

#include "framework/app/lesson.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace glint {

// One number as float and as double compute it.
struct Reading {
    std::string name;
    double in_float, in_double;
};

struct PixelReport {
    struct EdgeValue {
        std::int64_t value;  // E at the centre, 1/65536 px^2
        bool inclusive;      // a top or left edge
    };
    std::vector<std::string> words;  // the material and triangle, or that nothing is there
    double doubled_area = 0;         // of the triangle, px^2
    std::vector<EdgeValue> edges;    // three, or none where nothing is drawn; likewise:
    std::vector<Reading> screen;     // barycentrics in the window
    std::vector<Reading> readings;   // barycentrics, depth, the terms the shader names, radiance
};

// What is known of the centre of the pixel options.probe.
PixelReport probe_pixel(const Lesson& lesson, const Options& options, const Scene& scene);

// The same in words: the triangle that wins the pixel's centre, its edge values, barycentrics and
// depth, and every term of its shading that the shader names, in double beside float.
std::string explain_pixel(const Lesson& lesson, const Options& options, const Scene& scene);

}  // namespace glint
