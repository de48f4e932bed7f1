// The transfer curve of sRGB, IEC 61966-2-1: linear radiometric values to 8-bit codes and back.
#pragma once

#include "framework/math/polynomial.hpp"

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

// 255 * 1.055 * 2^(e/2.4) for e = -15 to 0.
inline constexpr auto scale_of_octave = [] {
    std::array<float, 16> scale{};
    double power = 255.0 * 1.055;
    for (std::size_t i = scale.size(); i-- > 0; power /= 1.3348398541700344) {  // 2^(1/2.4)
        scale[i] = static_cast<float>(power);
    }
    return scale;
}();

// mantissa^(1/2.4) for 1 <= mantissa < 2: a minimax fit of degree 4, relative error 9.1e-6.
struct Power {
    template <class F>
    F operator()(const F& mantissa) const {
        return polynomial(mantissa, 0.410369515F, 0.831304669F, -0.320840806F, 0.090199925F,
                          -0.0110241994F);
    }
};

// 255 times the curve, plus 1/2: the code in bits 12 to 19, its fraction below them, off by less
// than the last bit and what power is off by. For 0 <= x <= 1.
template <class F, class Fit = Power>
IntOf<F> code_and_fraction(F x, const Fit& power = {}) {
    using I = IntOf<F>;
    const I bits = bits_of(x);
    const F mantissa = float_from_bits((bits & I(0x7fffff)) | I(0x3f800000));
    const F scale = lookup16(scale_of_octave.data(), bits >> 23);
    // From 2048 to 4096, the last place of a float is 2^-12.
    const F curve = fma(scale, power(mantissa), F(2048.0F + 0.5F - 255.0F * 0.055F));
    const F line = fma(x, F(255.0F * 12.92F), F(2048.0F + 0.5F));
    return bits_of(select(x <= F(0.0031308F), line, curve));
}

template <class F>
IntOf<F> limited_code_and_fraction(F linear) {
    return code_and_fraction(min(max(linear, F(0.0F)), F(1.0F)));
}

}  // namespace srgb

// The code, 0..255, nearest to 255 times the curve; within 1/300 of half way between two codes it
// may be either. 0 for NaN. F is float or lanes.
template <class F>
IntOf<F> srgb_code(F linear) {
    using I = IntOf<F>;
    return (srgb::limited_code_and_fraction(linear) >> 12) & I(255);
}

// The codes of a linear colour, opaque, as Rgba8 lies in memory. Inlined, or constants would be
// loaded anew for every register.
template <class F>
[[gnu::always_inline]] inline IntOf<F> opaque_code(F r, F g, F b) {
    using I = IntOf<F>;
    static_assert(std::endian::native == std::endian::little);
    const I red = srgb::limited_code_and_fraction(r);
    const I green = srgb::limited_code_and_fraction(g);
    const I blue = srgb::limited_code_and_fraction(b);
    return ((red >> 12) & I(0xff)) | ((green >> 4) & I(0xff00)) | ((blue << 4) & I(0xff0000)) |
           I(static_cast<std::int32_t>(0xFF000000U));
}

inline std::uint8_t linear_to_srgb(float linear) {
    return static_cast<std::uint8_t>(srgb_code(linear));
}

// The linear value, 0..1, that a code stands for.
inline float srgb_to_linear(std::uint8_t code) {
    return srgb::linear_of_code[code];
}

}  // namespace glint
