// x^n as 2^(n log2 x), with the shortcuts that one takes first.
#include "framework/math/pow.hpp"

#include "lessons/09_normalised_phong/normalised_phong.hpp"
#include "tests/oracle/random.hpp"
#include "tests/stability/row.hpp"
#include "tests/worst.hpp"

#include <cmath>

namespace glint::stability {
namespace {

double relative(double x, double exact) {
    return std::abs(x - exact) / std::abs(exact);
}

TEST_CASE("pow at 0: 2^(n log2 x) of x = 0, n = 0") {
    row(in_all_numbers([]<Real T>() {
            const T zero(0.0F);
            return Errors{std::abs(value(exp2(zero * log2(zero))) - 1),
                          std::abs(value(pow(zero, zero)) - 1)};
        }),
        infinite, 0);
}

TEST_CASE("the lobe at n = 0: pow(max(V.R, 0), 0) behind the mirror direction") {
    row(in_all_numbers([]<Real T>() {
            const Incidence<T> away{T(0.5F), T(0.1F), T(0.9F)};  // V.R = -0.8
            return Errors{value(pow(max(v_dot_r(away), T(0.0F)), T(0.0F))),
                          value(phong_lobe(away, T(0.0F)))};
        }),
        1, 0);
}

// The largest relative error where x^n is not darker than 1e-4 of its peak.
template <Real T, class Power>
double worst_at(double n, Power power) {
    oracle::Random random(7);
    double worst = 0;
    for (int i = 0; i < 4000; ++i) {
        const auto x = static_cast<float>(std::exp(random.real(std::log(1e-4), 0) / n));
        worst = worse(worst, relative(value(power(T(x), T(n))), std::pow(double{x}, n)));
    }
    return worst;
}

TEST_CASE("pow at n = 1e6: by squaring") {
    row(in_all_numbers([]<Real T>() {
            const auto squaring = [](T x, T) {
                T power(1.0F);
                for (int n = 1'000'000; n > 0; n >>= 1, x *= x) {
                    power = (n & 1) != 0 ? power * x : power;
                }
                return power;
            };
            return Errors{worst_at<T>(1e6, squaring),
                          worst_at<T>(1e6, [](T x, T n) { return pow(x, n); })};
        }),
        1e-3, 4e-6);
}

TEST_CASE("n log2 x with too few bits: the mantissa taken from 1 to 2") {
    row(in_floats([]<Real T>() {
            // Below 1 the exponent is -1, and its sum with the mantissa's logarithm, near 1,
            // cancels.
            const auto few_bits = [](T x, T n) {
                const T of_mantissa = log2(x * T(2.0F));
                return exp2(n * (T(-1.0F) + of_mantissa));
            };
            return Errors{worst_at<T>(1e6, few_bits),
                          worst_at<T>(1e6, [](T x, T n) { return pow(x, n); })};
        }),
        0.01, 4e-6);
    CHECK(worst_at<double>(1e6, [](double x, double n) { return pow(x, n); }) == 0);
}

TEST_CASE("subnormal results: 2^k put into the exponent's bits") {
    const double n = 300;
    const double x = std::exp2(-0.46);  // x^n = 2^-138
    row(in_floats([&]<Real T>() {
            const T product = T(n) * log2(T(x));
            const T k = to_float(round_to_int(product));
            const auto bits = bits_of(exp2(product - k)) + (round_to_int(product) << 23);
            const double exact = std::pow(value(T(x)), n);
            return Errors{relative(value(float_from_bits(bits)), exact),
                          relative(value(pow(T(x), T(n))), exact)};
        }),
        1e6, 1e-3);
    CHECK(relative(pow(x, n), std::pow(x, n)) == 0);
}

}  // namespace
}  // namespace glint::stability
