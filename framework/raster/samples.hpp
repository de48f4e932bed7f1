// Where a pixel is sampled: the standard positions of Direct3D 11 (functional
// specification, 19.2.4) for 1, 2, 4, 8 and 16 samples. They lie on a grid of 1/16 pixel, so
// coverage stays exact.
#pragma once

#include "framework/math/error.hpp"
#include "framework/math/fixed.hpp"
#include "framework/math/one_lane.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string>

namespace glint {

struct SampleOffset {  // from the pixel's centre, in 1/256 pixel, x to the right, y down
    int x, y;
};

namespace sample_detail {
constexpr SampleOffset sixteenth(int x, int y) {
    return {16 * x, 16 * y};
}
inline constexpr std::array one{sixteenth(0, 0)};
inline constexpr std::array two{sixteenth(4, 4), sixteenth(-4, -4)};
inline constexpr std::array four{sixteenth(-2, -6), sixteenth(6, -2), sixteenth(-6, 2),
                                 sixteenth(2, 6)};
inline constexpr std::array eight{sixteenth(1, -3),  sixteenth(-1, 3), sixteenth(5, 1),
                                  sixteenth(-3, -5), sixteenth(-5, 5), sixteenth(-7, -1),
                                  sixteenth(3, 7),   sixteenth(7, -7)};
inline constexpr std::array sixteen{
    sixteenth(1, 1),   sixteenth(-1, -3), sixteenth(-3, 2),  sixteenth(4, -1),
    sixteenth(-5, -2), sixteenth(2, 5),   sixteenth(5, 3),   sixteenth(3, -5),
    sixteenth(-2, 6),  sixteenth(0, -7),  sixteenth(-4, -6), sixteenth(-6, 4),
    sixteenth(-8, 0),  sixteenth(7, -4),  sixteenth(6, 7),   sixteenth(-7, -8)};
}  // namespace sample_detail

inline constexpr int max_samples = 16;

// The offsets for 1, 2, 4, 8 or 16 samples, nearest to the centre first; Error for other counts.
inline std::span<const SampleOffset> sample_offsets(int samples) {
    switch (samples) {
        case 1:
            return sample_detail::one;
        case 2:
            return sample_detail::two;
        case 4:
            return sample_detail::four;
        case 8:
            return sample_detail::eight;
        case 16:
            return sample_detail::sixteen;
        default:
            throw Error("samples a pixel: " + std::to_string(samples) +
                        " is not one of 1, 2, 4, 8, 16");
    }
}

struct OffsetRange {
    SampleOffset low{0, 0}, high{0, 0};
};

// What the offsets lie between, in x and in y.
inline OffsetRange offset_range(int samples) {
    OffsetRange r;
    for (const SampleOffset o : sample_offsets(samples)) {
        r.low = {std::min(r.low.x, o.x), std::min(r.low.y, o.y)};
        r.high = {std::max(r.high.x, o.x), std::max(r.high.y, o.y)};
    }
    return r;
}

// The first and the last pixel, from 0 to `last`, that have a sample between two window positions
// of 1/256 pixel. I is int or lanes of it.
template <class I>
I first_pixel(I position, int highest_offset) {
    const int up = subpixel_one - 1 - subpixel_one / 2 - highest_offset;
    return max((position + I(up)) >> subpixel_bits, I(0));
}
template <class I>
I last_pixel(I position, int lowest_offset, int last) {
    return min((position - I(subpixel_one / 2 + lowest_offset)) >> subpixel_bits, I(last));
}

}  // namespace glint
