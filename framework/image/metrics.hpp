// How different a test picture is from its reference, in numbers.
#pragma once

#include "framework/image/image.hpp"

namespace glint {

// Over red, green and blue of the 8-bit codes; alpha is not looked at. All values are finite for
// every picture, but for psnr.
struct Metrics {
    double max = 0.0;        // largest difference, in codes
    double rmse = 0.0;       // root of the mean squared difference, in codes
    double psnr = 0.0;       // 20 log10(255 / rmse) in dB; infinity for equal pictures
    double ssim = 0.0;       // mean structural similarity, 1 for equal pictures: ssim.hpp
    double flip_mean = 0.0;  // 0..1: flip.hpp
    double flip_max = 0.0;
    double over_one = 0.0;  // share of the pixels that differ by more than one code, 0..1
    int worst_x = 0;        // the first pixel, row by row from the top, that differs by max
    int worst_y = 0;
};

// Error: sizes that differ, empty pictures.
Metrics measure_difference(const SrgbImage& reference, const SrgbImage& test);

// The largest difference of linear pictures in sRGB codes, 0..255, before these are rounded; values
// are clamped to 0..1. Infinity where only one is NaN. Error: sizes that differ.
double largest_code_difference(const LinearImage& reference, const LinearImage& test);

}  // namespace glint
