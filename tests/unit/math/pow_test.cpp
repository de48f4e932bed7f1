#include "framework/math/pow.hpp"

#include "tests/unit/math/lane_types.hpp"
#include "tests/worst.hpp"

#include <doctest/doctest.h>

#include <array>
#include <random>

namespace glint {
namespace {

constexpr float smallest = std::numeric_limits<float>::denorm_min();
constexpr float normal = std::numeric_limits<float>::min();
constexpr float largest = std::numeric_limits<float>::max();

// How far a result is from the true value, in units of the last place of a float of that size.
double ulps(float result, double truth) {
    const auto nearest = static_cast<float>(truth);
    if (!std::isfinite(result) || !std::isfinite(nearest)) {
        return same(result, nearest) ? 0.0 : static_cast<double>(infinity);
    }
    int exponent = 0;
    static_cast<void>(std::frexp(truth, &exponent));
    return std::ldexp(std::abs(static_cast<double>(result) - truth), 24 - std::max(exponent, -125));
}

// A million floats of every size and sign, NaN and infinity among them.
template <class F, class Visit>
void sample_floats(unsigned seed, Visit visit) {
    std::array<float, 16> x{};
    for (std::uint64_t bits = seed % 4096; bits < std::uint64_t{1} << 32; bits += 4096) {
        for (std::size_t k = 0; k < x.size(); ++k) {
            const auto spread = static_cast<std::uint32_t>(bits + k * 0x10001000U);
            x[k] = std::bit_cast<float>(spread);
        }
        visit(load<F>(x.data()));
    }
}

template <class F, class Op, class Reference>
double worst_ulps(unsigned seed, Op op, Reference reference) {
    double worst = 0.0;
    sample_floats<F>(seed, [&](F x) {
        const F r = op(x);
        for (int k = 0; k < lanes_of<F>; ++k) {
            const double error = ulps(lane(r, k), reference(static_cast<double>(lane(x, k))));
            worst = worse(worst, error);
        }
    });
    return worst;
}

template <class F>
float log2_of(float x) {
    return lane(log2(F(x)), lanes_of<F> - 1);
}
template <class F>
float exp2_of(float x) {
    return lane(exp2(F(x)), lanes_of<F> - 1);
}
template <class F>
float pow_of(float x, float n) {
    return lane(pow(F(x), F(n)), lanes_of<F> - 1);
}

TEST_CASE_TEMPLATE("log2 and exp2 are off by less than 2 ulp", F, float, ALL_LANES) {
    const unsigned seed = std::random_device()();
    CAPTURE(seed);
    const auto exact_log2 = [](double x) { return std::log2(x); };
    const auto exact_exp2 = [](double x) { return std::exp2(x); };
    CHECK(worst_ulps<F>(
              seed, [](F x) { return log2(x); }, exact_log2) < 2.0);
    CHECK(worst_ulps<F>(
              seed, [](F x) { return exp2(x); }, exact_exp2) < 2.0);
}

TEST_CASE_TEMPLATE("one lane computes the same bits as many", F, ALL_LANES) {
    const unsigned seed = std::random_device()();
    CAPTURE(seed);
    int different = 0;
    sample_floats<F>(seed, [&](F x) {
        const F n = x * F(0.37F) + F(2.0F);
        const F bounded = abs(x) / (abs(x) + F(1.0F));
        for (int k = 0; k < lanes_of<F>; ++k) {
            different += !same(lane(log2(x), k), log2(lane(x, k)));
            different += !same(lane(exp2(x), k), exp2(lane(x, k)));
            const float exponent = lane(n, 0);  // the same in all lanes
            different += !same(lane(pow(bounded, F(exponent)), k), pow(lane(bounded, k), exponent));
        }
    });
    CHECK(different == 0);
}

TEST_CASE_TEMPLATE("log2 at the ends of its range", F, float, ALL_LANES) {
    CHECK(same(log2_of<F>(1.0F), 0.0F));
    CHECK(same(log2_of<F>(0.0F), -infinity));
    CHECK(same(log2_of<F>(-0.0F), -infinity));
    CHECK(same(log2_of<F>(infinity), infinity));
    CHECK(same(log2_of<F>(-1.0F), nan));
    CHECK(same(log2_of<F>(-infinity), nan));
    CHECK(same(log2_of<F>(nan), nan));
    CHECK(same(log2_of<F>(-nan), nan));
    for (int e = -149; e < 128; ++e) {
        CHECK(log2_of<F>(std::ldexp(1.0F, e)) == static_cast<float>(e));
    }
}

TEST_CASE_TEMPLATE("exp2 at the ends of its range", F, float, ALL_LANES) {
    CHECK(same(exp2_of<F>(infinity), infinity));
    CHECK(same(exp2_of<F>(-infinity), 0.0F));
    CHECK(same(exp2_of<F>(nan), nan));
    CHECK(same(exp2_of<F>(-nan), nan));
    CHECK(same(exp2_of<F>(smallest), 1.0F));
    CHECK(same(exp2_of<F>(128.0F), infinity));
    CHECK(exp2_of<F>(std::nextafter(128.0F, 0.0F)) < infinity);
    CHECK(same(exp2_of<F>(-150.0F), 0.0F));
    CHECK(same(exp2_of<F>(std::nextafter(-150.0F, 0.0F)), smallest));
    CHECK(same(exp2_of<F>(-1.0e30F), 0.0F));
    for (int e = -149; e < 128; ++e) {
        CHECK(same(exp2_of<F>(static_cast<float>(e)), std::ldexp(1.0F, e)));
    }
}

TEST_CASE_TEMPLATE("pow where a factor is 0, 1, infinite or not a number", F, float, ALL_LANES) {
    for (const float x : {0.0F, -0.0F, 1.0F, 0.5F, 3.0F, -3.0F, smallest, largest, infinity, nan}) {
        CHECK(same(pow_of<F>(x, 0.0F), 1.0F));
        CHECK(same(pow_of<F>(x, -0.0F), 1.0F));
        CHECK(same(pow_of<F>(1.0F, x), 1.0F));
    }
    for (const float n : {smallest, 1e-30F, 0.5F, 50.0F, 1e6F, largest, infinity}) {
        CHECK(same(pow_of<F>(0.0F, n), 0.0F));
        CHECK(same(pow_of<F>(-0.0F, n), 0.0F));
        CHECK(same(pow_of<F>(0.0F, -n), infinity));
        CHECK(same(pow_of<F>(infinity, n), infinity));
        CHECK(same(pow_of<F>(infinity, -n), 0.0F));
        CHECK(same(pow_of<F>(-0.5F, n), n == 50.0F ? 0x1p-50F : nan));
        CHECK(same(pow_of<F>(nan, n), nan));
        CHECK(same(pow_of<F>(n == 0.5F ? 2.0F : 0.5F, nan), nan));
    }
    CHECK(same(pow_of<F>(0.5F, largest), 0.0F));
    CHECK(same(pow_of<F>(2.0F, infinity), infinity));
    CHECK(same(pow_of<F>(0.5F, 149.0F), smallest));
    CHECK(same(pow_of<F>(smallest, 1.0F), smallest));
    CHECK(same(pow_of<F>(std::nextafter(1.0F, 0.0F), 1e10F), 0.0F));
}

TEST_CASE_TEMPLATE("pow keeps the error that it states", F, float, ALL_LANES) {
    const unsigned seed = std::random_device()();
    CAPTURE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> log_exponent(-3.0, 14.0);  // n from 0.05 to 10^6
    std::uniform_real_distribution<double> log_result(-125.0, 0.0);
    double worst = 0.0;
    for (int i = 0; i < 100000; ++i) {
        const auto n = static_cast<float>(std::exp(log_exponent(random)));
        const auto x = static_cast<float>(std::exp2(log_result(random) / static_cast<double>(n)));
        const double truth = std::pow(static_cast<double>(x), static_cast<double>(n));
        const double y = static_cast<double>(n) * std::log2(static_cast<double>(x));
        if (truth >= static_cast<double>(normal)) {
            const double error = std::abs(static_cast<double>(pow_of<F>(x, n)) - truth) / truth;
            worst = worse(worst, error / ((1.2 + 1.7 * std::abs(y)) * 0x1p-23));
        }
    }
    CHECK(worst < 1.0);
}

TEST_CASE_TEMPLATE("whole exponents are reached by squaring", F, float, ALL_LANES) {
    const unsigned seed = std::random_device()();
    CAPTURE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> log_result(-125.0, 125.0);
    for (int n = 0; n <= 64; ++n) {
        CHECK(pow_of<F>(2.0F, static_cast<float>(n)) ==
              (n == 128 ? infinity : std::ldexp(1.0F, n)));
        CHECK(pow_of<F>(-1.0F, static_cast<float>(n)) == (n % 2 == 0 ? 1.0F : -1.0F));
        double worst = 0.0;
        for (int i = 0; i < 1000; ++i) {
            const auto x = static_cast<float>(std::exp2(log_result(random) / std::max(n, 1)));
            const double truth = std::pow(static_cast<double>(x), n);
            const float y = pow_of<F>(x, static_cast<float>(n));
            worst = worse(worst, std::abs(static_cast<double>(y) - truth) / truth);
        }
        CHECK(worst <= n * 0x1p-24);
    }
    CHECK(same(pow_of<F>(nan, 3.0F), nan));
    CHECK(same(pow_of<F>(infinity, 3.0F), infinity));
    CHECK(same(pow_of<F>(0.0F, 3.0F), 0.0F));
}

TEST_CASE_TEMPLATE("a uniform exponent needs no cast", T, float, double, ALL_LANES) {
    const T cube = pow(T(0.5F), 3.0F);
    CHECK(all(cube == T(0.125F)));
}

TEST_CASE("for double they are the standard library's") {
    CHECK(log2(0.3) == std::log2(0.3));
    CHECK(exp2(0.3) == std::exp2(0.3));
    CHECK(pow(0.3, 50.0) == std::pow(0.3, 50.0));
}

}  // namespace
}  // namespace glint
