// Two pictures of one size in one, for the live window.
#pragma once

#include "framework/image/image.hpp"

namespace glint {

// The left picture up to a white line, one pixel wide with black beside it, at column 0..width - 1;
// the right picture beyond. Error: sizes that differ.
SrgbImage split_picture(const SrgbImage& left, const SrgbImage& right, int column);

// The largest difference of a pixel's three codes, in every pixel. No measure of what is seen, as
// FLIP is, but quick enough for every frame.
struct CodeDifference {
    SrgbImage picture;  // heat colours of difference_heat()
    int largest = 0;    // codes, 0..255
    int x = 0, y = 0;   // the first pixel, row by row, that has it
    double share = 0;   // of the pixels differ, 0..1
};
CodeDifference code_difference(const SrgbImage& a, const SrgbImage& b);

// The square root, so that one code shows beside 255: 0..1 for 0..255 codes.
float difference_heat(int codes);

}  // namespace glint
