// Structural similarity: Wang, Bovik, Sheikh, Simoncelli, "Image Quality Assessment: From Error
// Visibility to Structural Similarity", IEEE Transactions on Image Processing 13(4), 2004.
#pragma once

#include "framework/image/image.hpp"

namespace glint {

// Mean SSIM, at most 1 and 1 for equal pictures, of the luma 0.2126 R + 0.7152 G + 0.0722 B of the
// code values; Gaussian window of 11x11 pixels with sigma 1.5, population covariance. As in
// scikit-image, the mean leaves out the 5 pixels along each edge; it takes in every pixel where the
// picture is less than 11 wide or high. Error: sizes that differ, empty pictures.
double mean_ssim(const SrgbImage& reference, const SrgbImage& test);

}  // namespace glint
