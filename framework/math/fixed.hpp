// Fixed point 24.8: window positions in 1/256 pixel.
#pragma once

#include "framework/math/one_lane.hpp"

namespace glint {

inline constexpr int subpixel_bits = 8;
inline constexpr int subpixel_one = 1 << subpixel_bits;
inline constexpr int guard_band = 16384;  // pixels; positions lie within +-guard_band

// The nearest 1/256 pixel, ties to even; |pixels| <= guard_band. T is float or lanes.
template <class T>
auto snap(T pixels) {
    return round_to_int(pixels * T(static_cast<float>(subpixel_one)));
}

}  // namespace glint
