// The transfer curve of sRGB, IEC 61966-2-1: linear radiometric values to 8-bit codes and back.
#pragma once

#include "framework/math/polynomial.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

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

// The least float whose code is higher: the first at or above the linear value that is encoded half
// way to the next code.
inline constexpr auto end_of_code = [] {
    std::array<float, 256> end{};
    for (std::size_t code = 0; code < 255; ++code) {
        const double exact = srgb_decode((static_cast<double>(code) + 0.5) / 255.0);
        end[code] = static_cast<float>(exact);
        if (static_cast<double>(end[code]) < exact) {
            end[code] = std::bit_cast<float>(std::bit_cast<std::uint32_t>(end[code]) + 1);
        }
    }
    end[255] = std::numeric_limits<float>::infinity();
    return end;
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

// 255 times the curve, plus 1/2: the code in bits 12 to 19, its fraction below them, off by less
// than the last bit. For 0 <= x <= 1.
template <class F>
IntOf<F> code_and_fraction(F x) {
    using I = IntOf<F>;
    const I bits = bits_of(x);
    const F mantissa = float_from_bits((bits & I(0x7fffff)) | I(0x3f800000));
    // mantissa^(1/2.4): a minimax fit of degree 6, relative error 1.9e-7.
    const F power = polynomial(mantissa, 0.350306869F, 1.06413138F, -0.687737048F, 0.390423328F,
                               -0.145197615F, 0.0309279542F, -0.00285470439F);
    const F scale = lookup16(scale_of_octave.data(), bits >> 23);
    // From 2048 to 4096, the last place of a float is 2^-12.
    const F curve = fma(scale, power, F(2048.0F + 0.5F - 255.0F * 0.055F));
    const F line = fma(x, F(255.0F * 12.92F), F(2048.0F + 0.5F));
    return bits_of(select(x <= F(0.0031308F), line, curve));
}

// Whether the code may be a neighbour's: the fraction is all zeros or all ones.
template <class I>
auto is_doubtful(const I& code_and_fraction) {
    return ((code_and_fraction + I(1)) & I(0xffe)) == I(0);
}

// The code of 0 <= x <= 1, doubtful or not.
template <class F>
IntOf<F> exact_code(F x) {
    using I = IntOf<F>;
    const I low = ((code_and_fraction(x) - I(1)) >> 12) & I(255);
    return low + select(x >= gather(end_of_code.data(), low), I(1), I(0));
}

// Not inlined, or opaque_code() would save registers for it, needed or not.
template <class F>
[[gnu::noinline]] IntOf<F> exact_codes(F r, F g, F b) {
    return exact_code(r) | (exact_code(g) << 8) | (exact_code(b) << 16);
}

template <class F>
F limited(F linear) {
    return min(max(linear, F(0.0F)), F(1.0F));
}

}  // namespace srgb

// The code, 0..255, nearest to 255 times the curve as if computed exactly; 0 for NaN. F is float or
// lanes.
template <class F>
IntOf<F> srgb_code(F linear) {
    using I = IntOf<F>;
    const F x = srgb::limited(linear);
    const I code = srgb::code_and_fraction(x);
    if (any(srgb::is_doubtful(code))) [[unlikely]] {
        return srgb::exact_code(x);
    }
    return (code >> 12) & I(255);
}

// The codes of a linear colour, opaque, as Rgba8 lies in memory: one test for all three.
template <class F>
[[gnu::always_inline]] inline IntOf<F> opaque_code(F r, F g, F b) {
    using I = IntOf<F>;
    static_assert(std::endian::native == std::endian::little);
    const I opaque(static_cast<std::int32_t>(0xFF000000U));
    r = srgb::limited(r);
    g = srgb::limited(g);
    b = srgb::limited(b);
    const I red = srgb::code_and_fraction(r);
    const I green = srgb::code_and_fraction(g);
    const I blue = srgb::code_and_fraction(b);
    const auto doubt_r = srgb::is_doubtful(red);
    const auto doubt_g = srgb::is_doubtful(green);
    const auto doubt_b = srgb::is_doubtful(blue);
    if (any(doubt_r | doubt_g | doubt_b)) [[unlikely]] {
        return srgb::exact_codes(r, g, b) | opaque;
    }
    return ((red >> 12) & I(0xff)) | ((green >> 4) & I(0xff00)) | ((blue << 4) & I(0xff0000)) |
           opaque;
}

inline std::uint8_t linear_to_srgb(float linear) {
    return static_cast<std::uint8_t>(srgb_code(linear));
}

// The linear value, 0..1, that a code stands for.
inline float srgb_to_linear(std::uint8_t code) {
    return srgb::linear_of_code[code];
}

}  // namespace glint
