#include "lessons/11_fresnel_conductor/fresnel_conductor.hpp"
#include "lessons/11_fresnel_conductor/metals.hpp"
#include "tests/unit/lessons/lane_value.hpp"
#include "tests/worst.hpp"

#include <doctest/doctest.h>

#include <complex>

namespace glint {
namespace {

// Fresnel's formulas as lesson 10 has them, with the complex index.
Reflectances<double> by_complex_numbers(double ior, double k, double c1) {
    const std::complex<double> n2(ior, k);
    const std::complex<double> sine = std::sqrt(1 - c1 * c1) / n2;
    const std::complex<double> c2 = std::sqrt(1.0 - sine * sine);
    const double par = std::norm((c2 - n2 * c1) / (c2 + n2 * c1));
    const double perp = std::norm((c1 - n2 * c2) / (c1 + n2 * c2));
    return {par, perp, (par + perp) / 2};
}

// As the slide prints them.
Reflectances<double> as_printed(double ior, double k, double c) {
    const double q = (ior * ior + k * k) * c * 2;
    const double par = (q - 2 * ior * c + 1) / (q + 2 * ior * c + 1);
    const double perp = (q - 2 * ior * c + c * c) / (q + 2 * ior * c + c * c);
    return {par, perp, (par + perp) / 2};
}

struct Worst {
    double parallel = 0, perpendicular = 0, unpolarised = 0;
    double degrees = 0;  // where the unpolarised error is worst
};

Worst worst_of_approximation(double ior, double k, double step = 0.05) {
    Worst worst;
    for (double degrees = 0; degrees <= 90; degrees += step) {
        const double c = cos_of_degrees(degrees);
        const auto exact = fresnel_conductor(ior, k, c);
        const auto near = fresnel_conductor_approximate(ior, k, c);
        const auto error = [&](auto share) { return std::abs(near.*share - exact.*share); };
        using R = Reflectances<double>;
        worst.parallel = worse(worst.parallel, error(&R::parallel));
        worst.perpendicular = worse(worst.perpendicular, error(&R::perpendicular));
        if (error(&R::unpolarised) > worst.unpolarised) {
            worst.unpolarised = error(&R::unpolarised);
            worst.degrees = degrees;
        }
    }
    return worst;
}

TEST_CASE("11.1 both polarisations are the complex formula's") {
    for (const double ior : {0.04, 0.5, 1.0, 1.5, 2.9, 20.0}) {
        for (const double k : {0.0, 1e-3, 0.5, 2.5, 7.7, 40.0}) {
            for (int i = 0; i <= 1000; ++i) {
                const double c = i / 1000.0;
                if (ior <= 1 && k == 0) {
                    continue;  // the square root's branch: see total reflection
                }
                const auto computed = fresnel_conductor(ior, k, c);
                const auto exact = by_complex_numbers(ior, k, c);
                CAPTURE(ior);
                CAPTURE(k);
                CAPTURE(c);
                REQUIRE(std::abs(computed.parallel - exact.parallel) < 1e-12);
                REQUIRE(std::abs(computed.perpendicular - exact.perpendicular) < 1e-12);
                REQUIRE(std::abs(computed.unpolarised - exact.unpolarised) < 1e-12);
            }
        }
    }
}

TEST_CASE("11.1 without k it is lesson 10's dielectric, total reflection included") {
    for (const double ior : {0.5, 0.75, 1.0, 1.33, 1.5, 2.4}) {
        for (int i = 0; i <= 1000; ++i) {
            const double c = i / 1000.0;
            const auto metal = fresnel_conductor(ior, 0.0, c);
            const auto glass = fresnel_dielectric(1.0, ior, c);
            CAPTURE(ior);
            CAPTURE(c);
            REQUIRE(std::abs(metal.parallel - glass.parallel) < 1e-7);
            REQUIRE(std::abs(metal.perpendicular - glass.perpendicular) < 1e-7);
        }
    }
}

TEST_CASE("both are exact along the normal and at grazing incidence") {
    for (const Metal& metal : metals) {
        for (int band = 0; band < 3; ++band) {
            const double ior = double{metal.ior[band]};
            const double k = double{metal.k[band]};
            const double f0 = ((ior - 1) * (ior - 1) + k * k) / ((ior + 1) * (ior + 1) + k * k);
            for (const auto formula :
                 {fresnel_conductor<double>, fresnel_conductor_approximate<double>}) {
                CHECK(formula(ior, k, 1.0).parallel == doctest::Approx(f0).epsilon(1e-14));
                CHECK(formula(ior, k, 1.0).perpendicular == doctest::Approx(f0).epsilon(1e-14));
                CHECK(formula(ior, k, 0.0).parallel == doctest::Approx(1).epsilon(1e-14));
                CHECK(formula(ior, k, 0.0).perpendicular == doctest::Approx(1).epsilon(1e-14));
            }
        }
    }
}

TEST_CASE("the metals' reflectances along the normal") {
    const double expected[5][3] = {{.957, .792, .408},
                                   {.935, .624, .538},
                                   {.990, .983, .980},
                                   {.906, .915, .922},
                                   {.531, .512, .496}};
    for (std::size_t m = 0; m < metals.size(); ++m) {
        for (int band = 0; band < 3; ++band) {
            CAPTURE(metals[m].name);
            const double ior = double{metals[m].ior[band]};
            CHECK(std::abs(fresnel_conductor(ior, double{metals[m].k[band]}, 1.0).unpolarised -
                           expected[m][band]) < 6e-4);
        }
    }
}

TEST_CASE("11.2 the approximation's worst error for metals") {
    struct Row {
        double parallel[3], perpendicular[3], unpolarised[3], degrees[3];
    };
    constexpr Row rows[] = {
        {{.0054, .0280, .0403}, {.0019, .0172, .0338}, {.0020, .0059, .0058}, {72, 67, 82}},
        {{.0078, .0346, .0363}, {.0027, .0222, .0255}, {.0028, .0071, .0064}, {72, 71, 73}},
        {{.0011, .0022, .0032}, {.0003, .0007, .0015}, {.0005, .0008, .0009}, {74, 72, 67}},
        {{.0046, .0052, .0061}, {.0008, .0010, .0014}, {.0021, .0023, .0026}, {80, 78, 76}},
        {{.0130, .0130, .0162}, {.0057, .0055, .0078}, {.0050, .0052, .0058}, {83, 83, 82}},
    };
    for (std::size_t m = 0; m < metals.size(); ++m) {
        for (int band = 0; band < 3; ++band) {
            CAPTURE(metals[m].name);
            CAPTURE(band);
            const Worst worst =
                worst_of_approximation(double{metals[m].ior[band]}, double{metals[m].k[band]});
            CHECK(std::abs(worst.parallel - rows[m].parallel[band]) < 6e-5);
            CHECK(std::abs(worst.perpendicular - rows[m].perpendicular[band]) < 6e-5);
            CHECK(std::abs(worst.unpolarised - rows[m].unpolarised[band]) < 6e-5);
            CHECK(std::abs(worst.degrees - rows[m].degrees[band]) < 0.6);
        }
    }
}

TEST_CASE("11.2 the approximation is useless for glass") {
    const Worst glass = worst_of_approximation(1.5, 0);
    CHECK(std::abs(glass.parallel - .1093) < 6e-5);
    CHECK(std::abs(glass.perpendicular - .0988) < 6e-5);
    CHECK(std::abs(glass.unpolarised - .0987) < 6e-5);
    CHECK(std::abs(glass.degrees - 79) < 0.6);
}

TEST_CASE("11.2 when it may be used: the worst error by ior^2 + k^2") {
    const double q[] = {1.05, 1.5, 2, 2.25, 4, 8, 16, 32, 64, 128};
    const double error[] = {.50, .19, .118, .099, .043, .017, .0073, .0043, .0025, .0014};
    for (int i = 0; i < 10; ++i) {
        double worst = 0;
        for (double turn = 0; turn <= 90; turn += 0.5) {
            const double ior = std::max(1e-6, std::sqrt(q[i]) * cos_of_degrees(turn));
            const double k = std::sqrt(q[i]) * std::sin(turn * pi / 180);
            worst = worse(worst, worst_of_approximation(ior, k, 0.25).unpolarised);
        }
        CAPTURE(q[i]);
        CHECK(worst == doctest::Approx(error[i]).epsilon(0.03));
    }
}

TEST_CASE("as the slide prints them the formulas are wrong along the normal") {
    const double gold = as_printed(.4241, 2.4721, 1).unpolarised;
    CHECK(std::abs(gold - .882) < 6e-4);
    CHECK(std::abs(as_printed(1.3831, 1.9155, 1).unpolarised - .630) < 6e-4);
    CHECK(std::abs(as_printed(1.0066, 2.5823, 1).unpolarised - .781) < 6e-4);
    CHECK(std::abs(as_printed(2.9497, 2.9318, 1).unpolarised - .716) < 6e-4);
    CHECK(std::abs(as_printed(1.3831, 1.9155, 1e-9).unpolarised - .80) < 6e-3);  // never 1
    CHECK(as_printed(0.2, 0, 0.01).perpendicular < -0.6);
}

TEST_CASE("a real index does not make a metal") {
    const double aluminium = double{metals[3].ior.g};
    CHECK(fresnel_dielectric(1.0, aluminium, 1.0).unpolarised < 6e-5);
    CHECK(std::abs(fresnel_conductor(aluminium, double{metals[3].k.g}, 1.0).unpolarised - .915) <
          6e-4);
    CHECK(650 / (4 * pi * double{metals[0].k.r}) == doctest::Approx(14.4).epsilon(0.005));  // nm
}

TEST_CASE("the errors of the polarisations have opposite signs") {
    const double k = double{metals[0].k.g};
    const double ior = double{metals[0].ior.g};
    for (const double degrees : {30.0, 50.0, 67.0, 80.0}) {
        const auto exact = fresnel_conductor(ior, k, cos_of_degrees(degrees));
        const auto near = fresnel_conductor_approximate(ior, k, cos_of_degrees(degrees));
        CHECK((near.parallel - exact.parallel) * (near.perpendicular - exact.perpendicular) < 0);
    }
}

TEST_CASE("a metal's reflectance dips before grazing incidence") {
    const double k = double{metals[3].k[0]};
    const double ior = double{metals[3].ior[0]};
    const double dip = fresnel_conductor(ior, k, cos_of_degrees(82.3)).unpolarised;
    CHECK(std::abs(dip - .826) < 6e-4);
    for (int i = 0; i <= 900; ++i) {
        CHECK(fresnel_conductor(ior, k, cos_of_degrees(i / 10.0)).unpolarised > dip - 1e-5);
    }
}

TEST_CASE_TEMPLATE("11 in every number type", T, float, ALL_LANES) {
    for (const float ior : {0.04F, 0.75F, 1.0F, 1.5F, 2.9F, 20.0F}) {
        const double error = ior < 0.1F ? 5e-6 : 1e-6;  // 1 - ior^2 cancels cos^2
        for (const float k : {0.0F, 0.01F, 1.9155F, 7.7F}) {
            for (const float c : {0.0F, 1e-8F, 1e-4F, 0.01F, 0.1F, 0.3F, 0.5F, 0.9F, 1.0F}) {
                CAPTURE(ior);
                CAPTURE(k);
                CAPTURE(c);
                const auto r = fresnel_conductor(T(ior), T(k), T(c));
                const auto exact = fresnel_conductor(double{ior}, double{k}, double{c});
                CHECK(std::abs(value(r.parallel) - exact.parallel) < error);
                CHECK(std::abs(value(r.perpendicular) - exact.perpendicular) < error);
                CHECK(std::abs(value(r.unpolarised) - exact.unpolarised) < error);
                const auto a = fresnel_conductor_approximate(T(ior), T(k), T(c));
                const auto e = fresnel_conductor_approximate(double{ior}, double{k}, double{c});
                CHECK(std::abs(value(a.parallel) - e.parallel) < error);
                CHECK(std::abs(value(a.perpendicular) - e.perpendicular) < error);
                CHECK(std::abs(value(a.unpolarised) - e.unpolarised) < error);
            }
        }
    }
}

TEST_CASE_TEMPLATE("11 at its ends", T, float, double, ALL_LANES) {
    for (const float ior : {1e-6F, 0.5F, 1.0F, 1.0001F, 1.5F, 1e6F}) {
        for (const float k : {0.0F, 1e-6F, 1.0F, 1e6F}) {
            for (const float c : {-1.0F, 0.0F, 1e-8F, 1e-3F, 0.5F, 1.0F, 2.0F, nan}) {
                CAPTURE(ior);
                CAPTURE(k);
                CAPTURE(c);
                for (const auto formula :
                     {fresnel_conductor<T>, fresnel_conductor_approximate<T>}) {
                    const auto r = formula(T(ior), T(k), T(c));
                    for (const T& share : {r.parallel, r.perpendicular, r.unpolarised}) {
                        CHECK(value(share) >= 0);  // and a number
                        CHECK(value(share) <= 1);
                    }
                }
            }
            const bool air = ior == 1 && k == 0;
            for (const float c : {-1.0F, 0.0F, nan}) {
                const auto r = fresnel_conductor(T(ior), T(k), T(c));
                CHECK(value(r.unpolarised) == doctest::Approx(air ? 0 : 1).epsilon(1e-6));
            }
        }
    }
    for (const float ior : {1e-16F, 1e-18F, 1e-22F, 1e-30F, 1e-40F}) {  // its square is lost
        for (const float c : {0.0F, 1e-8F, 0.5F, 1.0F}) {
            const auto r = fresnel_conductor(T(ior), T(0.0F), T(c));
            CHECK(value(r.parallel) == doctest::Approx(1));
            CHECK(value(r.perpendicular) == doctest::Approx(1));
        }
    }
    for (const float c : {0.0F, 1e-8F, 0.5F, 1.0F}) {  // air in air
        CHECK(value(fresnel_conductor(T(1.0F), T(0.0F), T(c)).unpolarised) < 1e-12);
    }
}

}  // namespace
}  // namespace glint
