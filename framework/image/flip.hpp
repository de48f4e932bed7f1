// FLIP: how different two pictures look when one flips between them. P. Andersson, J. Nilsson,
// T. Akenine-Moeller, M. Oskarsson, K. Astroem, M. Fairchild, "FLIP: A Difference Evaluator for
// Alternating Images", HPG 2020. The steps have the paper's names.
#pragma once

#include "framework/image/image.hpp"

namespace glint {

// A 4K screen, 0.7 m wide, seen from 0.7 m: 3840 pi / 180.
inline constexpr float default_pixels_per_degree = 67.0206433F;

// The difference of each pixel, from 0 to 1. Defined for a single pixel too: what lies beyond the
// edge repeats it. Error: sizes that differ, empty pictures.
Image<float> flip_map(const SrgbImage& reference, const SrgbImage& test,
                      float pixels_per_degree = default_pixels_per_degree);

}  // namespace glint
