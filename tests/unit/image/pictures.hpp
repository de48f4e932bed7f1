// Pictures that the tests of the metrics share.
#pragma once

#include "framework/image/png.hpp"

#include <string>

namespace glint {

inline SrgbImage metric_picture(const std::string& name) {
    return read_png("tests/data/metrics/" + name + ".png");
}

inline SrgbImage grey_picture(int width, int height, std::uint8_t code) {
    return {width, height, Rgba8{code, code, code, 255}};
}

// A rising pattern that differs from pixel to pixel and from channel to channel.
inline SrgbImage patterned(int width, int height, int seed) {
    SrgbImage image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const auto code = [&](int a) { return static_cast<std::uint8_t>(a * seed); };
            image(x, y) = {code(x * 7 + y), code(x + y * 11), code(x * y + 3), 255};
        }
    }
    return image;
}

}  // namespace glint
