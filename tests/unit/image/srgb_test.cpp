#include "framework/image/srgb.hpp"

#include "tests/unit/math/lane_types.hpp"

#include <doctest/doctest.h>

#include <bit>

namespace glint {
namespace {

// The linear value that is encoded half way from code - 1 to code, from the standard's formula.
long double lower_end(int code) {
    const long double encoded = (static_cast<long double>(code) - 0.5L) / 255.0L;
    return encoded <= 0.04045L ? encoded / 12.92L : std::pow((encoded + 0.055L) / 1.055L, 2.4L);
}

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

TEST_CASE_TEMPLATE("codes round as if computed exactly", F, float, ALL_LANES) {
    for (int code = 1; code < 256; ++code) {
        const long double end = lower_end(code);
        const auto near = static_cast<float>(end);
        for (int steps = -300; steps <= 300; ++steps) {
            const float x = neighbour(near, steps);
            CHECK(code_of<F>(x) == (static_cast<long double>(x) < end ? code - 1 : code));
        }
    }
}

TEST_CASE_TEMPLATE("codes rise with the linear value, lane by lane", F, float, ALL_LANES) {
    int code = 0;
    long double end = lower_end(1);
    bool exact = true;
    for (std::int32_t bits = bits_of(0x1p-14F); bits < bits_of(1.0F); bits += 64 * lanes_of<F>) {
        const F x = float_from_bits(iota<IntOf<F>>() * IntOf<F>(64) + IntOf<F>(bits));
        const auto codes = srgb_code(x);
        for (int k = 0; k < lanes_of<F>; ++k) {
            while (code < 255 && static_cast<long double>(lane(x, k)) >= end) {
                end = lower_end(++code + 1);
            }
            exact = exact && lane(codes, k) == code;
        }
    }
    CHECK(exact);
    CHECK(code == 255);
}

TEST_CASE_TEMPLATE("a colour's codes are those of its channels", F, float, ALL_LANES) {
    using I = IntOf<F>;
    const auto opaque = static_cast<std::int32_t>(0xFF000000U);
    for (int code = 1; code < 256; ++code) {
        for (int steps = -20; steps <= 20; ++steps) {
            // In the last lane alone, all but one in turn far from doubt.
            const auto near = neighbour(static_cast<float>(lower_end(code)), steps);
            const F x = select(iota<I>() == I(lanes_of<F> - 1), F(near), F(0.25F));
            const std::int32_t at = code_of<F>(near);
            const F clear(0.5F);
            CHECK(lane(opaque_code(x, clear, clear), lanes_of<F> - 1) ==
                  (at | 188 << 8 | 188 << 16 | opaque));
            CHECK(lane(opaque_code(clear, x, clear), lanes_of<F> - 1) ==
                  (188 | at << 8 | 188 << 16 | opaque));
            CHECK(lane(opaque_code(F(nan), F(infinity), x), lanes_of<F> - 1) ==
                  (255 << 8 | at << 16 | opaque));
        }
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
