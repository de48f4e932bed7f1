// How far a picture is from the same shading in double, and two pictures from each other.
#pragma once

#include "tests/bench/glint_frames.hpp"

#include <vector>

namespace glint {

// The scene with exact coverage and everything after it in double.
struct ReferencePicture {
    std::vector<Rgb<double>> radiance;  // by pixel
    std::vector<bool> covered;
};
ReferencePicture reference_picture(const BenchScene& bench);

struct Accuracy {
    double median_error = 0;      // relative, of the components of radiance
    double largest_error = 0;     // likewise, where coverage is equal
    int coverage_differs = 0;     // pixels
    double share_off_by_one = 0;  // of the covered pixels' 8-bit codes
    int largest_codes = 0;        // difference of a code
};
// covered: what the picture to judge covers.
Accuracy accuracy(const ReferencePicture& reference, const LinearImage& radiance,
                  const SrgbImage& codes, const std::vector<bool>& covered);

struct Difference {
    int largest = 0;  // codes
    double mean = 0;
};
Difference difference(const SrgbImage& a, const SrgbImage& b);

}  // namespace glint
