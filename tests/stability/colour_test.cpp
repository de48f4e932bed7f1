// From radiance to codes, and from two pictures to one number.
#include "framework/image/metrics.hpp"
#include "framework/image/srgb.hpp"
#include "framework/math/pow.hpp"
#include "tests/stability/row.hpp"

#include <algorithm>

namespace glint::stability {
namespace {

// The power without the straight piece near 0, rounded to 8 bits as a cast does.
template <Real T>
int code_by_power(T x) {
    const T encoded = T(1.055F) * pow(x, T(1 / 2.4F)) - T(0.055F);
    return static_cast<int>(std::lround(255 * value(encoded)));
}
template <Real T>
int code_by_glint(T x) {
    if constexpr (std::same_as<T, double>) {
        return srgb_code(static_cast<float>(x));
    } else {
        return lane(srgb_code(x), lanes_of<T> - 1);
    }
}

template <Real T>
Errors code_errors(double from, double to, int naive_bits) {
    Errors worst;
    for (int i = 0; i <= 1000; ++i) {
        const auto x = static_cast<float>(from + (to - from) * i / 1000);
        const double exact = std::round(255 * std::clamp(srgb_encode(double{x}), 0.0, 1.0));
        const int code = code_by_power(T(x)) & ((1 << naive_bits) - 1);
        add(worst, {std::abs(code - exact), std::abs(code_by_glint(T(x)) - exact)});
    }
    return worst;
}

void ramp(const std::string& name, double to, int naive_bits) {
    const auto shade = [&](const auto& code) {
        return [=](int x, int) {
            return Rgb<float>(srgb_to_linear(static_cast<std::uint8_t>(code(to * x / 64))));
        };
    };
    picture(name, 65, 12, 3, shade([naive_bits](double x) {
                return std::max(code_by_power(x), 0) & ((1 << naive_bits) - 1);
            }),
            shade([](double x) { return code_by_glint(x); }));
}

TEST_CASE("sRGB near 0: the power without the straight piece") {
    row(in_all_numbers([]<Real T>() {
            Errors worst;
            for (const double x : {0.0, 1e-5, 1e-4, 1e-3}) {
                add(worst, {std::abs(code_by_power(T(x)) - std::round(255 * srgb_encode(x))),
                            std::abs(code_by_glint(T(x)) - std::round(255 * srgb_encode(x)))});
            }
            return worst;
        }),
        10, 0);
}

TEST_CASE("sRGB above 1: cut to 8 bits without a limit") {
    ramp("above_one", 3, 8);
    row(in_all_numbers([]<Real T>() { return code_errors<T>(0.9, 3, 8); }), 250, 0);
}

TEST_CASE("sRGB of NaN") {
    row(in_all_numbers([]<Real T>() {
            const T not_a_number(std::numeric_limits<float>::quiet_NaN());
            return Errors{value(T(1.055F) * pow(not_a_number, T(1 / 2.4F)) - T(0.055F)),
                          1.0 * code_by_glint(not_a_number)};
        }),
        infinite, 0);
}

// Structural similarity of two constant pictures, without the constants that keep it from 0/0.
template <Real T>
double bare_ssim(float a, float b) {
    const int n = 121;
    T sum_a(0.0F), sum_b(0.0F), sum_aa(0.0F), sum_bb(0.0F), sum_ab(0.0F);
    for (int i = 0; i < n; ++i) {
        sum_a += T(a);
        sum_b += T(b);
        sum_aa += T(a) * T(a);
        sum_bb += T(b) * T(b);
        sum_ab += T(a) * T(b);
    }
    const T count(static_cast<float>(n));
    const T mean_a = sum_a / count;
    const T mean_b = sum_b / count;
    const T var_a = sum_aa / count - mean_a * mean_a;
    const T var_b = sum_bb / count - mean_b * mean_b;
    const T covariance = sum_ab / count - mean_a * mean_b;
    const T two(2.0F);
    return value(two * mean_a * mean_b / (mean_a * mean_a + mean_b * mean_b) * two * covariance /
                 (var_a + var_b));
}

TEST_CASE("SSIM and FLIP of constant pictures") {
    row(in_all_numbers([]<Real T>() {
            const SrgbImage black(16, 16, {0, 0, 0, 255});
            const Metrics m = measure_difference(black, black);
            return Errors{bare_ssim<T>(0, 0) - 1,
                          std::abs(m.ssim - 1) + m.flip_mean + m.flip_max + m.rmse};
        }),
        infinite, 0);
    const Metrics apart = measure_difference(SrgbImage(16, 16, {0, 0, 0, 255}),
                                             SrgbImage(16, 16, {255, 255, 255, 255}));
    CHECK(std::isfinite(apart.ssim + apart.flip_mean + apart.flip_max + apart.psnr));
    CHECK(apart.ssim < 1e-3);
    CHECK(apart.flip_mean > 0.9);
}

}  // namespace
}  // namespace glint::stability
