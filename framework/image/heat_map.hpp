// Pictures that show where two pictures differ.
#pragma once

#include "framework/image/image.hpp"

namespace glint {

// 0 is almost black, then purple, red, orange, and 1 pale yellow; equal steps of error look like
// equal steps of colour. Below 0 counts as 0, above 1 and NaN as 1.
Rgba8 heat_colour(float error);

SrgbImage heat_map(const Image<float>& error);

// Reference, test and their heat map from left to right, parted by white lines. Error: sizes that
// differ, empty pictures.
SrgbImage side_by_side(const SrgbImage& reference, const SrgbImage& test, const SrgbImage& heat);

}  // namespace glint
