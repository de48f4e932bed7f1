#include "lessons/09_normalised_phong/normalised_phong.hpp"
#include "lessons/09_normalised_phong/phong_albedo.hpp"
#include "framework/measure/gonioreflectometer.hpp"
#include "tests/unit/math/lane_types.hpp"

#include <doctest/doctest.h>

#include <cmath>

namespace glint {
namespace {

constexpr double pi = std::numbers::pi;

double cosine(double degrees) {
    return degrees == 90 ? 0.0 : std::cos(degrees * pi / 180);
}

struct Lobe {
    double n;
    bool normalised = true;
    template <Real T>
    Rgb<T> operator()(const Incidence<T>& g) const {
        return Rgb<T>(normalised ? normalised_phong(g, T(n)) : phong_lobe(g, T(n)));
    }
};

double measured(double n, double degrees, Fixed fixed = Fixed::light) {
    return directional_albedo(Lobe{n}, cosine(degrees), fixed).r;
}

TEST_CASE("09.1 the factor is (n + 2)/(2 pi)") {
    for (const double n : {0.0, 0.5, 1.0, 32.0, 1e3, 1e6}) {
        CHECK(phong_normalisation(n) == doctest::Approx((n + 2) / (2 * pi)).epsilon(1e-15));
    }
    CHECK(phong_normalisation(32.0) == doctest::Approx(5.411).epsilon(1e-4));
}

TEST_CASE("09.1 along the normal the factor makes the albedo 1; without it, it is 2 pi/(n + 2)") {
    for (const double n : {0.0, 1e-3, 0.5, 1.0, 2.0, 10.0, 100.0, 1e3, 1e6, 1e7}) {
        CAPTURE(n);
        CHECK(std::abs(measured(n, 0) - 1) < 1e-9);
        CHECK(directional_albedo(Lobe{n, false}, 1.0).r ==
              doctest::Approx(2 * pi / (n + 2)).epsilon(1e-9));
    }
    const auto alone = [](double n) { return directional_albedo(Lobe{n, false}, 1.0).r; };
    CHECK(std::abs(alone(1) - 2.094) < 5e-4);  // the errata's row
    CHECK(std::abs(alone(4) - 1.047) < 5e-4);
    CHECK(std::abs(alone(5) - 0.898) < 5e-4);
    CHECK(std::abs(alone(100) - 0.0616) < 5e-5);
    CHECK(std::abs(alone(1000) - 0.00627) < 5e-6);
}

TEST_CASE("the albedo that is measured is the closed form's") {
    for (const double n : {0.0, 0.25, 1.0, 2.0, 7.0, 10.0, 61.0, 63.0, 100.0, 1e3, 1e5, 1e7}) {
        for (const double degrees : {0.0, 15.0, 30.0, 45.0, 60.0, 75.0, 85.0, 89.0, 89.99}) {
            CAPTURE(n);
            CAPTURE(degrees);
            const double A = phong_albedo(n, cosine(degrees));
            CHECK(std::abs(measured(n, degrees) - A) < 2e-8);
            CHECK(std::abs(measured(n, degrees, Fixed::view) - A) <
                  2e-8);  // the lobe is reciprocal
        }
    }
}

TEST_CASE("the closed form is the table's") {
    struct Row {
        double n, A[9];
    };
    constexpr double degrees[] = {0, 30, 45, 60, 75, 80, 85, 89, 90};
    constexpr Row rows[] = {{1, {1, .8808, .7554, .6090, .4584, .4099, .3631, .3271, .3183}},
                            {10, {1, .8660, .7074, .5047, .2919, .2281, .1713, .1320, .1230}},
                            {100, {1, .8660, .7071, .5000, .2589, .1752, .0976, .0491, .0398}},
                            {1000, {1, .8660, .7071, .5000, .2588, .1736, .0872, .0232, .0126}}};
    for (const Row& row : rows) {
        for (int i = 0; i < 9; ++i) {
            CAPTURE(row.n);
            CAPTURE(degrees[i]);
            CHECK(std::abs(phong_albedo(row.n, cosine(degrees[i])) - row.A[i]) < 5.1e-5);
        }
    }
}

// Reference values from 50-digit arithmetic.
TEST_CASE("the closed form keeps its digits from n = 0 to 1e7") {
    const auto near = [](double n, double c, double exact) {
        CAPTURE(n);
        CAPTURE(c);
        CHECK(std::abs(phong_albedo(n, c) / exact - 1) < 1e-13);
    };
    near(0.001, 0.3, 0.64967658608824113);
    near(0.5, 0.01, 0.38638941636713575);
    near(1, 0.5, 0.60899778104422936);
    near(1, 0.72, 0.7651167267320272);
    near(10, 0.2, 0.24701552640000001);
    near(61.9, 0.01, 0.055658485078475577);
    near(62.1, 0.3, 0.30030665669545175);
    near(100, 0.1, 0.10821076585533653);
    near(1000, 1e-08, 0.012612514089181032);
    near(10000.0, 0.02, 0.020084839548203248);
    near(1000000.0, 0.001, 0.0010833153496023442);
    near(1000000.0, 0.5, 0.5);
    near(10000000.0, 0.0, 0.00012615662294709239);
    near(10000000.0, 0.0001, 0.00018241240984061407);
    near(10000000.0, 0.002, 0.0020000000000060651);
}

TEST_CASE("the closed form at its ends") {
    for (const double n : {0.0, 1e-9, 0.5, 1.0, 31.0, 1e3, 1e7}) {
        CAPTURE(n);
        CHECK(phong_albedo(n, 1) == 1);
        double before = 0;
        for (int i = 0; i <= 1000; ++i) {
            const double A = phong_albedo(n, i / 1000.0);
            REQUIRE(A > before);
            REQUIRE(A >= i / 1000.0 * (1 - 1e-13));
            REQUIRE(A <= 1);
            before = A;
        }
        if (n > 1e3) {
            CHECK(phong_albedo(n, 0) == doctest::Approx(1 / std::sqrt(2 * pi * n)).epsilon(1e-6));
        }
    }
    CHECK(phong_albedo(1, 0) == doctest::Approx(1 / pi).epsilon(1e-15));
    CHECK(phong_albedo(10, -1) == phong_albedo(10, 0));
    CHECK(phong_albedo(10, 2) == 1);
    for (const double c : {0.0, 1e-8, 0.1, 0.5, 0.8, 1.0}) {
        CHECK(phong_albedo(0, c) == doctest::Approx((1 + c) / 2).epsilon(1e-15));
    }
}

TEST_CASE("a perfect mirror of this kind returns half the light at 60 degrees") {
    CHECK(std::abs(measured(1000, 60) - 0.5) < 1e-8);
}

TEST_CASE("each term conserves energy, their sum does not") {
    const NormalisedPhong both{Rgb<float>(1.0F), Rgb<float>(1.0F), 32};
    const double expected[] = {2.00, 1.71, 1.50, 1.19};
    const double degrees[] = {0, 45, 60, 80};
    for (int i = 0; i < 4; ++i) {
        CHECK(std::abs(directional_albedo(both, cosine(degrees[i])).g - expected[i]) < 0.005);
    }
    const NormalisedPhong shared{Rgb<float>(0.75F), Rgb<float>(0.25F), 32};
    CHECK(directional_albedo(shared, 1.0).g == doctest::Approx(1).epsilon(1e-9));
}

TEST_CASE_TEMPLATE("09.2 the lobe in every number type", T, float, ALL_LANES) {
    for (const double n : {0.0, 0.5, 1.0, 10.0, 1e3, 1e6}) {
        for (const double degrees : {0.0, 0.05, 1.0, 30.0, 80.0, 89.0}) {
            const auto c = static_cast<float>(cosine(degrees));
            const Incidence<double> exact{1, double{c}, double{c}};  // L = N, so V.R = c
            const Incidence<T> g{T(1.0F), T(c), T(c)};
            const double truth = normalised_phong(exact, n);
            const float value = lane(normalised_phong(g, T(float(n))), lanes_of<T> - 1);
            CAPTURE(n);
            CAPTURE(degrees);
            // pow's own error grows with n log2(x); see pow.hpp
            const double bound = (4 + 2 * std::abs(n * std::log2(double{c}))) * 0x1p-23;
            CHECK(std::abs(double{value} - truth) <= truth * bound + 1e-37);
        }
    }
}

TEST_CASE_TEMPLATE("09.2 the lobe at its ends", T, float, double, ALL_LANES) {
    const auto lobe = [](float NL, float NV, float LV, float n) {
        const T value = normalised_phong(Incidence<T>{T(NL), T(NV), T(LV)}, T(n));
        if constexpr (std::same_as<T, double>) {
            return static_cast<float>(value);
        } else {
            return lane(value, lanes_of<T> - 1);
        }
    };
    const auto peak = [](float n) { return (n + 2) / static_cast<float>(2 * pi); };
    for (const float n : {0.0F, 0.5F, 1.0F, 2.0F, 1e3F, 1e6F}) {
        CAPTURE(n);
        CHECK(lobe(1, 1, 1, n) == doctest::Approx(peak(n)));            // L = V = N
        CHECK(lobe(0.5F, 0.5F, -0.5F, n) == doctest::Approx(peak(n)));  // V = R
        CHECK(lobe(1, 1.0000002F, 1, n) == doctest::Approx(peak(n)));   // V.R above 1 by rounding
        CHECK(lobe(0.5F, 0.5F, 0.9F, n) == 0);                          // V.R < 0
        CHECK(lobe(0.5F, 0.5F, 0.5F, n) == 0);                          // V.R = 0, n = 0 as well
        CHECK(lobe(0, 0, -1, n) == doctest::Approx(peak(n)));           // grazing mirror
        CHECK(lobe(1e-8F, 1e-8F, -1, n) == doctest::Approx(peak(n)));
        CHECK(lobe(nan, 0.5F, 0.5F, n) == 0);
    }
    CHECK(lobe(1, 1e-8F, 1e-8F, 0) == doctest::Approx(peak(0)));  // n = 0: half the directions
    CHECK(lobe(0.6F, -0.3F, -0.5F, 1) == doctest::Approx(0.14F * peak(1)));  // the viewer below
}

}  // namespace
}  // namespace glint
