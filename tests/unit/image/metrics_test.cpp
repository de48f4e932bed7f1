#include "framework/image/metrics.hpp"

#include "framework/math/error.hpp"
#include "tests/unit/image/pictures.hpp"

#include <doctest/doctest.h>

#include <cmath>

namespace glint {
namespace {

using doctest::Approx;

// Measured by the FLIP authors' tool 1.6 at 67.02 pixels per degree and by scikit-image, to the
// digits given.
struct Row {
    const char* test;
    double flip_mean, flip_max, rmse, psnr, max, ssim;
};
constexpr Row rows[] = {
    {"sphere_exponent", 0.014884, 0.702145, 2.843652, 39.0533, 50, 0.992408},
    {"sphere_no_fresnel", 0.071523, 0.978601, 14.464406, 24.9248, 143, 0.949818},
    {"sphere_shift", 0.035436, 0.464240, 7.176639, 31.0124, 109, 0.951778},
    {"sphere_noise", 0.076300, 0.230994, 7.540162, 30.5832, 34, 0.700977},
};

bool near(double a, double b, double tolerance) {
    return std::abs(a - b) <= tolerance;
}

TEST_CASE("the numbers are those of the reference tools") {
    const SrgbImage reference = metric_picture("sphere");
    for (const Row& row : rows) {
        CAPTURE(row.test);
        const Metrics m = measure_difference(reference, metric_picture(row.test));
        CHECK(m.max == row.max);
        CHECK(near(m.rmse, row.rmse, 6e-7));
        CHECK(near(m.psnr, row.psnr, 6e-5));
        CHECK(near(m.ssim, row.ssim, 6e-7));
        CHECK(near(m.flip_mean, row.flip_mean, 5e-6));
        CHECK(near(m.flip_max, row.flip_max, 5e-6));
    }
}

TEST_CASE("black against white") {
    const Metrics m = measure_difference(metric_picture("black"), metric_picture("white"));
    CHECK(m.max == 255);
    CHECK(m.rmse == 255);
    CHECK(m.psnr == 0);
    CHECK(m.over_one == 1);
    CHECK(near(m.ssim, 6.5025 / (255.0 * 255.0 + 6.5025), 1e-9));
    CHECK(near(m.flip_mean, 0.967407, 3e-5));  // the tool sums in single precision
    CHECK(near(m.flip_max, 0.967388, 5e-6));
}

TEST_CASE("equal pictures, of any size") {
    for (const auto& [width, height] : {std::pair(1, 1), {5, 5}, {1, 40}, {200, 3}, {33, 12}}) {
        const SrgbImage image = patterned(width, height, 5);
        const Metrics m = measure_difference(image, image);
        CHECK(m.max == 0);
        CHECK(m.rmse == 0);
        CHECK(m.psnr == std::numeric_limits<double>::infinity());
        CHECK(m.ssim == Approx(1.0).epsilon(1e-12));
        CHECK(m.flip_mean == 0);
        CHECK(m.flip_max == 0);
        CHECK(m.over_one == 0);
        CHECK(m.worst_x == 0);
        CHECK(m.worst_y == 0);
    }
}

TEST_CASE("code differences worked out by hand") {
    const SrgbImage reference = grey_picture(4, 2, 100);
    SrgbImage test = reference;
    test(1, 0) = {101, 99, 100, 0};     // one code, and an alpha that nobody looks at
    test(2, 1) = {100, 100, 97, 255};   // -3
    test(3, 1) = {103, 100, 100, 255};  // +3, later
    const Metrics m = measure_difference(reference, test);
    const double mean_square = (1 + 1 + 9 + 9) / 24.0;
    CHECK(m.max == 3);
    CHECK(m.rmse == Approx(std::sqrt(mean_square)).epsilon(1e-12));
    CHECK(m.psnr == Approx(10 * std::log10(255 * 255 / mean_square)).epsilon(1e-12));
    CHECK(m.over_one == 2.0 / 8.0);
    CHECK(m.worst_x == 2);
    CHECK(m.worst_y == 1);
}

TEST_CASE("every number is the same in either order") {
    const SrgbImage a = patterned(31, 23, 3);
    const SrgbImage b = patterned(31, 23, 11);
    const Metrics ab = measure_difference(a, b);
    const Metrics ba = measure_difference(b, a);
    CHECK(ab.max == ba.max);
    CHECK(ab.rmse == ba.rmse);
    CHECK(ab.ssim == Approx(ba.ssim).epsilon(1e-12));
    CHECK(ab.flip_mean == ba.flip_mean);
    CHECK(ab.over_one == ba.over_one);
}

TEST_CASE("small and constant pictures give finite numbers in range") {
    for (const auto& [width, height] : {std::pair(1, 1), {2, 1}, {5, 5}, {1, 64}, {10, 11}}) {
        for (const SrgbImage& test :
             {grey_picture(width, height, 255), patterned(width, height, 3)}) {
            const Metrics m = measure_difference(grey_picture(width, height, 0), test);
            CHECK(std::isfinite(m.psnr));
            CHECK(std::abs(m.ssim) <= 1);
            CHECK(m.flip_mean > 0);
            CHECK(m.flip_mean <= m.flip_max + 1e-6);
            CHECK(m.flip_max <= 1);
        }
    }
}

TEST_CASE("pictures of two sizes cannot be compared") {
    CHECK_THROWS_WITH_AS(measure_difference(grey_picture(192, 108, 0), grey_picture(64, 64, 0)),
                         doctest::Contains("192x108 pixels, the test picture 64x64"), Error);
    CHECK_THROWS_AS(measure_difference({}, {}), Error);
}

}  // namespace
}  // namespace glint
