// Pictures between radiance and what a screen shows.
#pragma once

#include "framework/image/image.hpp"

namespace glint {

// By srgb_code(): clamped to 0..1 and rounded; NaN is black. Opaque.
SrgbImage to_srgb(const LinearImage& image);

// 0..1. Alpha is dropped.
LinearImage to_linear(const SrgbImage& image);

}  // namespace glint
