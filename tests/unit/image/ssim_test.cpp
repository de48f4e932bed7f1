#include "framework/image/ssim.hpp"

#include "framework/math/error.hpp"
#include "tests/unit/image/pictures.hpp"

#include <doctest/doctest.h>

namespace glint {
namespace {

using doctest::Approx;

TEST_CASE("constant pictures differ by the luminance term alone") {
    const double c1 = 6.5025;
    for (const auto& [a, b] : {std::pair(0, 255), {100, 200}, {7, 8}, {0, 0}}) {
        const double expected = (2.0 * a * b + c1) / (1.0 * a * a + 1.0 * b * b + c1);
        for (const auto& [width, height] : {std::pair(1, 1), {5, 5}, {11, 11}, {30, 2}}) {
            const SrgbImage grey_a = grey_picture(width, height, static_cast<std::uint8_t>(a));
            const SrgbImage grey_b = grey_picture(width, height, static_cast<std::uint8_t>(b));
            CHECK(mean_ssim(grey_a, grey_b) == Approx(expected).epsilon(1e-9));
        }
    }
}

TEST_CASE("luma weighs the channels as BT.709 does") {
    const SrgbImage green(1, 1, {0, 200, 0, 255});
    const SrgbImage black = grey_picture(1, 1, 0);
    const double luma = 0.7152 * 200;
    CHECK(mean_ssim(black, green) == Approx(6.5025 / (luma * luma + 6.5025)).epsilon(1e-9));
}

TEST_CASE("a window of one pixel step, worked out by hand") {
    // 11x1 becomes a mean over all pixels; mirrored, the window of 2x1 sees p and 1-p of each code.
    const double share = [] {
        double here = 0.0;
        double all = 0.0;
        for (int x = -5; x <= 5; ++x) {
            const double weight = std::exp(-x * x / 4.5);
            all += weight;
            here += ((x % 4) + 4) % 4 == 0 || ((x % 4) + 4) % 4 == 3 ? weight : 0.0;
        }
        return here / all;
    }();
    SrgbImage step = grey_picture(2, 1, 0);
    step(1, 0) = {100, 100, 100, 255};
    const SrgbImage flat = grey_picture(2, 1, 50);
    const double variance = share * (1 - share) * 100 * 100;
    double expected = 0.0;
    for (const double mean : {100 * share, 100 * (1 - share)}) {
        expected += (2 * mean * 50 + 6.5025) * 58.5225 /
                    ((mean * mean + 2500 + 6.5025) * (variance + 58.5225)) / 2;
    }
    CHECK(mean_ssim(step, flat) == Approx(expected).epsilon(1e-9));
}

TEST_CASE("the outer 5 pixels see the difference only through the window") {
    const SrgbImage reference = patterned(40, 30, 3);
    SrgbImage corner = reference;
    corner(0, 0) = {255, 0, 255, 255};
    const double similar = mean_ssim(reference, corner);
    CHECK(similar < 1.0);
    CHECK(similar > 0.9999);
}

TEST_CASE("bad pairs") {
    CHECK_THROWS_WITH_AS(mean_ssim(grey_picture(3, 4, 0), grey_picture(4, 3, 0)),
                         "the reference has 3x4 pixels, the test picture 4x3: they must be of one "
                         "size",
                         Error);
    CHECK_THROWS_WITH_AS(mean_ssim({}, {}), "the pictures are empty", Error);
}

}  // namespace
}  // namespace glint
