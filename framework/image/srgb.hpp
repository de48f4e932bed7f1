// The transfer curve of sRGB, IEC 61966-2-1: linear radiometric values to 8-bit codes and back.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace glint {

// The curve itself, linear to encoded, for references and charts. Goes on beyond 0..1.
inline double srgb_encode(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

namespace srgb {
// Newton's iteration from above, where it falls until it has arrived. y >= 0.
constexpr double fifth_root(double y) {
    double root = y > 1.0 ? y : 1.0;
    for (;;) {
        const double next = root + 0.2 * (y / (root * root * root * root) - root);
        if (!(next < root)) {
            return root;
        }
        root = next;
    }
}
}  // namespace srgb

// Its inverse, encoded to linear, to a relative error of 1e-15.
constexpr double srgb_decode(double encoded) {
    if (encoded <= 0.04045) {
        return encoded / 12.92;
    }
    const double base = (encoded + 0.055) / 1.055;
    const double root = srgb::fifth_root(base);
    return base * base * root * root;  // base^2.4, where std::pow would not be constexpr
}

namespace srgb {

inline constexpr auto linear_of_code = [] {
    std::array<float, 256> linear{};
    for (std::size_t code = 0; code < linear.size(); ++code) {
        linear[code] = static_cast<float>(srgb_decode(static_cast<double>(code) / 255.0));
    }
    return linear;
}();

// thresholds[k] is the least float whose code is k + 1: the first at or above the linear value that
// is encoded half way from k to k + 1.
inline constexpr auto thresholds = [] {
    std::array<float, 255> least{};
    for (std::size_t k = 0; k < least.size(); ++k) {
        const double exact = srgb_decode((static_cast<double>(k) + 0.5) / 255.0);
        least[k] = static_cast<float>(exact);
        if (static_cast<double>(least[k]) < exact) {
            least[k] = std::bit_cast<float>(std::bit_cast<std::uint32_t>(least[k]) + 1);
        }
    }
    return least;
}();

}  // namespace srgb

// The linear value, 0..1, that a code stands for.
inline float srgb_to_linear(std::uint8_t code) {
    return srgb::linear_of_code[code];
}

// The code nearest to 255 times the curve, as if computed exactly; 0 for NaN.
inline std::uint8_t linear_to_srgb(float linear) {
    if (std::isnan(linear)) {
        return 0;
    }
    const auto above = std::ranges::upper_bound(srgb::thresholds, linear);
    return static_cast<std::uint8_t>(above - srgb::thresholds.begin());
}

}  // namespace glint
