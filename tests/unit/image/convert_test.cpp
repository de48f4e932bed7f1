#include "framework/image/convert.hpp"

#include <doctest/doctest.h>

#include <limits>

namespace glint {
namespace {

TEST_CASE("radiance is clamped and encoded, pixel by pixel") {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    LinearImage image(2, 2);
    image(0, 0) = {0.0F, 0.5F, 1.0F};
    image(1, 0) = {-1.0F, 2.0F, nan};
    image(0, 1) = {infinity, -infinity, 0.2158605F};  // the last is 128/255 of the code range
    image(1, 1) = {0.0F, 0.0F, 0.003035F};            // one hundredth of it, on the straight part
    const SrgbImage codes = to_srgb(image);
    CHECK(codes.width() == 2);
    CHECK(codes.height() == 2);
    CHECK(codes(0, 0) == Rgba8{0, 188, 255, 255});
    CHECK(codes(1, 0) == Rgba8{0, 255, 0, 255});
    CHECK(codes(0, 1) == Rgba8{255, 0, 128, 255});
    CHECK(codes(1, 1) == Rgba8{0, 0, 10, 255});
}

TEST_CASE("every code returns from linear, made opaque") {
    SrgbImage codes(256, 1);
    for (int code = 0; code < 256; ++code) {
        const auto c = static_cast<std::uint8_t>(code);
        codes(code, 0) = {c, static_cast<std::uint8_t>(255 - c), 7, 255};
    }
    CHECK(to_srgb(to_linear(codes)) == codes);
    codes(0, 0).a = 3;
    CHECK(to_srgb(to_linear(codes))(0, 0).a == 255);
}

TEST_CASE("an empty picture stays empty") {
    CHECK(to_srgb(LinearImage()).empty());
    CHECK(to_linear(SrgbImage()).empty());
}

}  // namespace
}  // namespace glint
