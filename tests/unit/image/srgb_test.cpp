#include "framework/image/srgb.hpp"

#include "tests/unit/math/lane_types.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

namespace glint {
namespace {

float neighbour(float x, int steps) {
    return float_from_bits(bits_of(x) + steps);
}

template <class F>
std::int32_t code_of(float linear) {
    return lane(srgb_code(F(linear)), lanes_of<F> - 1);
}

TEST_CASE("the curve is that of IEC 61966-2-1") {
    CHECK(srgb_encode(0.0) == 0.0);
    CHECK(srgb_encode(1.0) == doctest::Approx(1.0).epsilon(1e-15));
    CHECK(srgb_encode(0.002) == doctest::Approx(0.02584).epsilon(1e-15));
    CHECK(srgb_encode(0.5) == doctest::Approx(0.7353569830524495).epsilon(1e-14));
    CHECK(srgb_encode(-0.1) == doctest::Approx(-1.292).epsilon(1e-15));
    for (int i = -256; i <= 4096; ++i) {
        const double encoded = i / 512.0;
        const double base = (encoded + 0.055) / 1.055;
        const double linear = encoded <= 0.04045 ? encoded / 12.92 : std::pow(base, 2.4);
        CHECK(srgb_decode(encoded) == doctest::Approx(linear).epsilon(1e-14));
        CHECK(srgb_encode(srgb_decode(encoded)) == doctest::Approx(encoded).epsilon(1e-6));
    }
}

TEST_CASE("every code survives its decoding") {
    for (int code = 0; code < 256; ++code) {
        const float linear = srgb_to_linear(static_cast<std::uint8_t>(code));
        CHECK(linear == static_cast<float>(srgb_decode(code / 255.0)));
        CHECK(linear_to_srgb(linear) == code);
        CHECK(code_of<Float4>(linear) == code);
        CHECK(code_of<Float8>(linear) == code);
        CHECK(code_of<Float16>(linear) == code);
    }
    CHECK(srgb_to_linear(0) == 0.0F);
    CHECK(srgb_to_linear(255) == 1.0F);
}

// By how many codes the linear value lies beyond half way to its code's neighbours; 0 within.
double beyond_half(float linear, std::int32_t code) {
    return std::max(std::abs(code - 255 * srgb_encode(double{linear})) - 0.5, 0.0);
}
constexpr double most_beyond_half = 1.0 / 300;

TEST_CASE_TEMPLATE("codes round half way between two, or within 1/300 of it", F, float, ALL_LANES) {
    for (int code = 1; code < 256; ++code) {
        const auto half_way = static_cast<float>(srgb_decode((code - 0.5) / 255));
        for (int steps = -300; steps <= 300; ++steps) {
            const float x = neighbour(half_way, steps);
            CHECK(beyond_half(x, code_of<F>(x)) < most_beyond_half);
        }
    }
}

TEST_CASE_TEMPLATE("codes of all magnitudes round so, lane by lane", F, float, ALL_LANES) {
    double most = 0;
    int otherwise = 0;
    int all = 0;
    for (std::int32_t bits = bits_of(0x1p-14F); bits < bits_of(1.0F); bits += 64 * lanes_of<F>) {
        const F x = float_from_bits(iota<IntOf<F>>() * IntOf<F>(64) + IntOf<F>(bits));
        const auto codes = srgb_code(x);
        for (int k = 0; k < lanes_of<F>; ++k, ++all) {
            const double beyond = beyond_half(lane(x, k), lane(codes, k));
            most = std::max(most, beyond);
            otherwise += beyond > 0 ? 1 : 0;
        }
    }
    CHECK(most < most_beyond_half);
    CHECK(otherwise < all / 2000);
}

TEST_CASE_TEMPLATE("a colour's codes are those of its channels", F, float, ALL_LANES) {
    using I = IntOf<F>;
    const auto opaque = static_cast<std::int32_t>(0xFF000000U);
    const F grey(0.5F);
    for (int i = -8; i <= 1032; ++i) {
        const float linear = static_cast<float>(i) / 1024;
        const F x = select(iota<I>() == I(lanes_of<F> - 1), F(linear), F(0.25F));
        const std::int32_t at = code_of<F>(linear);
        CHECK(lane(opaque_code(x, grey, grey), lanes_of<F> - 1) ==
              (at | 188 << 8 | 188 << 16 | opaque));
        CHECK(lane(opaque_code(grey, x, grey), lanes_of<F> - 1) ==
              (188 | at << 8 | 188 << 16 | opaque));
        CHECK(lane(opaque_code(F(nan), F(infinity), x), lanes_of<F> - 1) ==
              (255 << 8 | at << 16 | opaque));
    }
}

TEST_CASE_TEMPLATE("what is out of range is clamped", F, float, ALL_LANES) {
    for (const float black : {0.0F, -0.0F, -1.0F, 1e-40F, -infinity, nan, -nan, -1e30F}) {
        CHECK(code_of<F>(black) == 0);
    }
    for (const float white : {1.0F, neighbour(1.0F, -1), 1.5F, 1e30F, infinity}) {
        CHECK(code_of<F>(white) == 255);
    }
    CHECK(linear_to_srgb(nan) == 0);
    CHECK(linear_to_srgb(0.5F) == 188);
}

}  // namespace
}  // namespace glint
