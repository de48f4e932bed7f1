#include "lessons/09_normalised_phong/normalised_phong.hpp"
#include "lessons/10_fresnel_dielectric/fresnel_dielectric.hpp"
#include "lessons/10_fresnel_dielectric/polished.hpp"
#include "framework/measure/gonioreflectometer.hpp"
#include "tests/unit/lessons/lane_value.hpp"

#include <doctest/doctest.h>

#include <complex>

namespace glint {
namespace {

double R(double n1, double n2, double degrees) {
    return fresnel_dielectric(n1, n2, cos_of_degrees(degrees)).unpolarised;
}

// The slides' formulas in complex arithmetic, where total reflection needs no case of its own.
Reflectances<double> by_complex_numbers(double n1, double n2, double c1) {
    const std::complex<double> sine = n1 / n2 * std::sqrt(1 - c1 * c1);
    const std::complex<double> c2 = std::sqrt(1.0 - sine * sine);
    const double par = std::norm((n1 * c2 - n2 * c1) / (n1 * c2 + n2 * c1));
    const double perp = std::norm((n1 * c1 - n2 * c2) / (n1 * c1 + n2 * c2));
    return {par, perp, (par + perp) / 2};
}

TEST_CASE("10.1 Snell's law") {
    for (const double n2 : {1.0, 1.33, 1.5, 2.4}) {
        for (const double degrees : {0.0, 10.0, 45.0, 80.0, 90.0}) {
            const double cos2 = refracted_cosine(1.0, n2, cos_of_degrees(degrees));
            const double sin1 = std::sin(degrees * pi / 180);
            CHECK(n2 * std::sqrt(1 - cos2 * cos2) == doctest::Approx(sin1).epsilon(1e-7));
        }
    }
    CHECK(refracted_cosine(1.5, 1.0, 0.5) == -1);  // none
    CHECK(refracted_cosine(2.0, 1.0, 1.0) == 1);
    CHECK(refracted_cosine(1.0, 1.0, 1e-8) == doctest::Approx(1e-8));
}

TEST_CASE("10.2 both polarisations are the complex formula's") {
    for (const double n1 : {0.5, 1.0, 1.33, 1.5, 2.4}) {
        for (const double n2 : {0.5, 1.0, 1.33, 1.5, 2.4, 50.0}) {
            for (int i = 1; i <= 1000 && n1 != n2; ++i) {
                const double c = i / 1000.0;
                const auto computed = fresnel_dielectric(n1, n2, c);
                const auto exact = by_complex_numbers(n1, n2, c);
                REQUIRE(std::abs(computed.parallel - exact.parallel) < 1e-12);
                REQUIRE(std::abs(computed.perpendicular - exact.perpendicular) < 1e-12);
                REQUIRE(std::abs(computed.unpolarised - exact.unpolarised) < 1e-12);
                // What arrives from the other side along the refracted ray is reflected as much.
                const double cos2 = refracted_cosine(n1, n2, c);
                if (cos2 > 0.01) {
                    REQUIRE(std::abs(fresnel_dielectric(n2, n1, cos2).unpolarised -
                                     exact.unpolarised) < 1e-7);
                }
            }
        }
    }
}

TEST_CASE("10.2 along the normal: ((n1 - n2)/(n1 + n2))^2 for either polarisation") {
    for (const double n2 : {0.7, 1.33, 1.5, 2.4}) {
        const auto r = fresnel_dielectric(1.0, n2, 1.0);
        const double f0 = (1 - n2) / (1 + n2) * (1 - n2) / (1 + n2);
        CHECK(r.parallel == doctest::Approx(f0).epsilon(1e-14));
        CHECK(r.perpendicular == doctest::Approx(f0).epsilon(1e-14));
    }
    CHECK(std::abs(R(1, 1.333, 0) - 0.0204) < 5e-5);
    CHECK(std::abs(R(1, 1.5, 0) - 0.0400) < 5e-5);
    CHECK(std::abs(R(1, 1.77, 0) - 0.077) < 5e-4);   // ruby
    CHECK(std::abs(R(1, 2.417, 0) - 0.172) < 5e-4);  // diamond
    CHECK(R(1, 3, 0) == doctest::Approx(0.25));
    CHECK(R(1.5, 1.33, 0) == doctest::Approx(0.17 / 2.83 * 0.17 / 2.83));  // glass in water
}

TEST_CASE("10.2 the table of the text") {
    constexpr double degrees[] = {0, 30, 45, 60, 70, 80, 85, 89};
    struct Row {
        double n, R[8];
    };
    constexpr Row rows[] = {{1.33, {.0201, .0211, .0275, .0591, .1327, .3469, .5827, .8960}},
                            {1.5, {.0400, .0415, .0502, .0892, .1710, .3877, .6128, .9042}},
                            {2.4, {.1696, .1711, .1788, .2094, .2694, .4332, .6222, .9000}}};
    for (const Row& row : rows) {
        for (int i = 0; i < 8; ++i) {
            CAPTURE(row.n);
            CAPTURE(degrees[i]);
            CHECK(std::abs(R(1, row.n, degrees[i]) - row.R[i]) < 5.1e-5);
        }
    }
}

TEST_CASE("10.2 at Brewster's angle no parallel polarised light is reflected") {
    for (const double n2 : {1.33, 1.5, 2.4}) {
        const double theta = std::atan(n2);
        CHECK(fresnel_dielectric(1.0, n2, std::cos(theta)).parallel < 1e-30);
        CHECK(fresnel_dielectric(1.0, n2, std::cos(theta)).perpendicular > 0.07);
        // There the reflected and the refracted ray are at right angles.
        CHECK(refracted_cosine(1.0, n2, std::cos(theta)) == doctest::Approx(std::sin(theta)));
    }
    CHECK(std::abs(std::atan(1.5) * 180 / pi - 56.31) < 0.005);
    CHECK(std::abs(fresnel_dielectric(1.0, 1.5, std::cos(std::atan(1.5))).perpendicular - .1479) <
          5e-5);
    CHECK(R(1, 1.5, 40) > R(1, 1.5, 0));  // the mean never falls
}

TEST_CASE("10.2 beyond the critical angle everything is reflected") {
    const double critical = std::asin(1 / 1.5) * 180 / pi;
    CHECK(std::abs(critical - 41.81) < 0.005);
    CHECK(std::abs(std::asin(1 / 1.333) * 180 / pi - 48.61) < 0.005);
    CHECK(R(1.5, 1, critical - 1e-3) < 1);
    for (const double degrees : {critical + 1e-6, 42.0, 60.0, 89.0, 90.0}) {
        const auto r = fresnel_dielectric(1.5, 1.0, cos_of_degrees(degrees));
        CHECK(r.parallel == 1);
        CHECK(r.perpendicular == 1);
        CHECK(r.unpolarised == 1);
    }
    CHECK(std::abs(R(1.5, 1, 40) - 0.2453) < 5e-5);
}

TEST_CASE(
    "a constant reflectance misses a glass at 85 degrees 15 times, lesson 9's lobe 175 times") {
    const double glass = R(1, 1.5, 85);
    CHECK(glass / R(1, 1.5, 0) == doctest::Approx(15.3).epsilon(0.003));
    const NormalisedPhong lobe{Rgb<float>(0.0F), Rgb<float>(0.04F), 1000};
    const double albedo = directional_albedo(lobe, cos_of_degrees(85)).g;
    CHECK(std::abs(albedo - 0.0035) < 5e-5);
    CHECK(glass / albedo == doctest::Approx(175.8).epsilon(0.002));
}

TEST_CASE_TEMPLATE("10 in every number type", T, float, ALL_LANES) {
    for (const float n1 : {0.75F, 1.0F, 1.5F, 2.4F}) {
        for (const float n2 : {0.75F, 1.0F, 1.0001F, 1.33F, 2.4F, 1e6F}) {
            for (const float c : {0.0F, 1e-8F, 1e-4F, 0.01F, 0.1F, 0.3F, 0.5F, 0.9F, 1.0F}) {
                CAPTURE(n1);
                CAPTURE(n2);
                CAPTURE(c);
                const auto r = fresnel_dielectric(T(n1), T(n2), T(c));
                const auto exact = fresnel_dielectric(double{n1}, double{n2}, double{c});
                CHECK(std::abs(value(r.parallel) - exact.parallel) < 1e-6);
                CHECK(std::abs(value(r.perpendicular) - exact.perpendicular) < 1e-6);
                CHECK(std::abs(value(r.unpolarised) - exact.unpolarised) < 1e-6);
            }
        }
    }
}

TEST_CASE_TEMPLATE("10 at its ends", T, float, double, ALL_LANES) {
    const auto at = [](float n1, float n2, float c) {
        const auto r = fresnel_dielectric(T(n1), T(n2), T(c));
        CHECK(value(r.parallel) >= 0);
        CHECK(value(r.parallel) <= 1);
        CHECK(value(r.perpendicular) >= 0);
        CHECK(value(r.perpendicular) <= 1);
        return value(r.unpolarised);
    };
    for (const float c : {0.0F, 1e-8F, 0.5F, 1.0F}) {
        CHECK(at(1.5F, 1.5F, c) == 0);  // the same medium, 0/0 at grazing incidence
    }
    for (const float n2 : {0.5F, std::nextafter(1.0F, 0.0F), std::nextafter(1.0F, 2.0F), 1.5F}) {
        CHECK(at(1, n2, 0) == 1);
        CHECK(at(1, n2, -0.5F) == 1);  // below the horizon counts as on it
        CHECK(at(1, n2, nan) == 1);
        CHECK(at(1, n2, 2) == at(1, n2, 1));
    }
    CHECK(at(1, 1.5F, 1e-8F) == doctest::Approx(1).epsilon(1e-6));
}

template <class T>
using Fragment = Lit<NormalisedLambert>::Varyings<T>;

struct Half {
    template <Real T>
    Rgb<T> operator()(const T& cos_i) const {
        return Rgb<T>(T(0.5F) * cos_i / cos_i);
    }
};

TEST_CASE_TEMPLATE("a polished surface shows the studio in the mirror", T, float, double,
                   ALL_LANES) {
    const glm::vec3 eye(0, 1, 5);
    Lighting key;
    key.directional = {{glm::vec3(0, 0, 1), Rgb<float>(float(pi))}};
    const Polished<Half> surface{
        {{Rgb<float>(0.25F)}, key, eye}, {}, {.room = 2, .pool = 2, .lamps = 2}};
    const glm::vec3 V = normalize(eye);
    for (const glm::vec3& L : {glm::vec3(0.6F, 0, 0.8F), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1)}) {
        const glm::vec3 N = normalize(V + L);
        const Rgb<T> seen = surface(Fragment<T>{Vec3<T>(T(0.0F)), Vec3<T>(N)});
        CHECK(value(seen.g) == doctest::Approx(double{0.25F * N.z + Studio{}(L).g}));
    }
    const Polished<Half> wall{
        {{Rgb<float>(0.25F)}, key, eye}, {}, {.room = 2, .pool = 2, .lamps = 2}, true};
    CHECK(value(wall(Fragment<T>{Vec3<T>(T(0.0F)), Vec3<T>(glm::vec3(1, 0, 0))}).g) ==
          doctest::Approx(double{2 * Studio{}(-V).g}));
}

struct Grazing {
    template <Real T>
    Rgb<T> operator()(const T& cos_i) const {
        return Rgb<T>(fresnel_dielectric(T(1.0F), T(1.5F), cos_i).unpolarised);
    }
};

TEST_CASE_TEMPLATE("seen from behind, or without a normal, it is seen at grazing incidence", T,
                   float, double, ALL_LANES) {
    const Polished<Grazing> surface{{{Rgb<float>(0.0F)}, {}, glm::vec3(0, 1, 5)}, {}};
    const float light = Studio{}(-normalize(glm::vec3(0, 1, 5))).g;
    for (const glm::vec3& N : {glm::vec3(0, 0, -1), glm::vec3(0), glm::vec3(nan, 0, 1)}) {
        const Rgb<T> seen = surface(Fragment<T>{Vec3<T>(T(0.0F)), Vec3<T>(N)});
        CHECK(value(seen.g) == doctest::Approx(double{light}));
    }
}

}  // namespace
}  // namespace glint
