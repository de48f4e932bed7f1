// A triangle by lesson 18's edge functions: every pixel of the box about it is asked.
#pragma once

#include "lessons/18_scanline_to_tiles/scanline_to_tiles.hpp"

namespace glint::by_hand {

// Calls sink(x, y) for each pixel of a picture of width x height that the triangle covers, row by
// row. I is std::int32_t or lanes.
template <class I, class Sink>
void cover(const Corners& v, int width, int height, Sink&& sink) {
    constexpr int lanes = lanes_of<I>;
    const auto edges = set_up(v);
    const auto [left, right] = std::minmax({v[0].x, v[1].x, v[2].x});
    const auto [top, bottom] = std::minmax({v[0].y, v[1].y, v[2].y});
    const int last_x = std::min(right >> 8, width - 1);
    const int last_y = std::min(bottom >> 8, height - 1);
    for (int y = std::max(top >> 8, 0); y <= last_y; ++y) {
        for (int x = std::max(left >> 8, 0); x <= last_x; x += lanes) {
            const std::uint32_t bits = lane_bits(covered<I>(edges, x, y));
            for (int i = 0; i < lanes && x + i < width; ++i) {
                if ((bits >> i & 1U) != 0) {
                    sink(x + i, y);
                }
            }
        }
    }
}

}  // namespace glint::by_hand
