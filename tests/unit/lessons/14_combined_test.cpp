#include "lessons/09_normalised_phong/phong_albedo.hpp"
#include "lessons/14_combined/combined.hpp"
#include "lessons/14_combined/instruments.hpp"
#include "tests/unit/lessons/lane_value.hpp"

#include <doctest/doctest.h>

#include <random>

namespace glint {
namespace {

Combined white(float F0, float n, Remains remains) {
    return {Rgb<float>(1.0F), Rgb<float>(F0), n, remains};
}

double albedo(const Combined& brdf, double degrees, Fixed fixed = Fixed::light) {
    return directional_albedo(brdf, std::max(cos_of_degrees(degrees), 1e-9), fixed).g;
}

// The diffuse part alone.
struct Diffuse {
    double F0;
    bool by_angle;
    template <Real T>
    Rgb<T> operator()(const Incidence<T>& g) const {
        const Rgb<T> f0{T(F0)};
        const Rgb<T> cd(T(1.0F));
        return by_angle ? diffuse_by_angle(cd, f0, g) : diffuse_by_f0(cd, f0);
    }
};

TEST_CASE("lesson 13's sum reflects more than there is, along the normal already") {
    CHECK(std::abs(albedo(white(0.04F, 10, Remains::all), 0) - 1.04) < 1e-7);
    CHECK(std::abs(albedo(white(0.17F, 10, Remains::all), 0) - 1.17) < 1e-7);
    CHECK(std::abs(albedo(white(0.04F, 10, Remains::all), 80) - 1.0935) < 6e-5);
}

TEST_CASE("14.1 by angle: the diffuse part gives back Cd (1 - F(theta_i))") {
    for (const double F0 : {0.0, 0.04, 0.5, 1.0}) {
        for (const double degrees : {0.0, 30.0, 60.0, 85.0}) {
            const double c = cos_of_degrees(degrees);
            CHECK(std::abs(directional_albedo(Diffuse{F0, true}, c).g - (1 - schlick(F0, c))) <
                  1e-8);
        }
    }
}

TEST_CASE("14.2 by F0: it gives back Cd (1 - F0)") {
    for (const double F0 : {0.0, 0.04, 0.5, 1.0}) {
        for (const double degrees : {0.0, 60.0, 85.0}) {
            const double c = cos_of_degrees(degrees);
            CHECK(std::abs(directional_albedo(Diffuse{F0, false}, c).g - (1 - F0)) < 1e-8);
        }
    }
}

TEST_CASE("14.1 by angle: energy is conserved, whatever n, F0 and theta") {
    for (const float n : {1e-6F, 1.0F, 10.0F, 1000.0F}) {
        for (const float F0 : {0.0F, 0.04F, 0.5F, 1.0F}) {
            for (const double degrees : {0.0, 40.0, 60.0, 80.0, 89.9}) {
                CAPTURE(n);
                CAPTURE(F0);
                CAPTURE(degrees);
                const double c = cos_of_degrees(degrees);
                const double F = schlick(double{F0}, c);
                const double total = albedo(white(F0, n, Remains::by_angle), degrees);
                CHECK(total <= 1 + 1e-8);
                CHECK(std::abs(total - (1 - F + F * phong_albedo(double{n}, c))) < 1e-7);
            }
        }
    }
}

TEST_CASE("14.1 by angle: not reciprocal") {
    const Incidence<double> g = incidence_of_angles(80 * pi / 180, 0, 0);
    const Diffuse f{0.04, true};
    const double swapped = f(Incidence<double>{g.NV, g.NL, g.LV}).g;
    CHECK(std::abs(f(g).g / swapped - 0.6147) < 6e-5);  // (1 - F(80)) / (1 - F(0))
    CHECK(std::abs(relative_reciprocity_error(f, g) - 0.3853) < 6e-5);
}

TEST_CASE("the reciprocity error of the whole: the README's table") {
    const double expected[][4] = {// light, viewer, by angle, by F0
                                  {80, 0, .385, 0},
                                  {85, 45, .362, .206},
                                  {80, 60, .395, .480}};
    for (const auto& [light, viewer, by_angle, by_f0] : expected) {
        const auto g = incidence_of_angles(light * pi / 180, viewer * pi / 180, pi);
        const auto error = [&](Remains remains) {
            return relative_reciprocity_error(white(0.04F, 10, remains), g);
        };
        CHECK(std::abs(error(Remains::by_angle) - by_angle) < 6e-4);
        CHECK(std::abs(error(Remains::by_f0) - by_f0) < 6e-4);
    }
}

TEST_CASE("14.2 by F0: reciprocal to the bit") {
    for (const double light : {0.0, 0.5, 1.0, 1.5}) {
        for (const double viewer : {0.1, 0.7, 1.3}) {
            const auto g = incidence_of_angles(light, viewer, 2.0);
            CHECK(reciprocity_error(Diffuse{0.04, false}, g) == Rgb<double>(0));
        }
    }
}

TEST_CASE("14.2 by F0: above 1 near grazing") {
    constexpr double degrees[] = {0, 45, 60, 70, 80, 85};  // the README's table
    constexpr double all[] = {1.040, 1.030, 1.035, 1.057, 1.094, 1.111};
    constexpr double by_angle[] = {1.000, .988, .965, .899, .684, .463};
    constexpr double by_f0[] = {1.000, .990, .995, 1.017, 1.053, 1.071};
    for (int i = 0; i < 6; ++i) {
        CAPTURE(degrees[i]);
        CHECK(std::abs(albedo(white(0.04F, 10, Remains::all), degrees[i]) - all[i]) < 6e-4);
        CHECK(std::abs(albedo(white(0.04F, 10, Remains::by_angle), degrees[i]) - by_angle[i]) <
              6e-4);
        CHECK(std::abs(albedo(white(0.04F, 10, Remains::by_f0), degrees[i]) - by_f0[i]) < 6e-4);
    }
}

TEST_CASE("14.2 by F0: from which angle it is above 1") {
    const auto onset = [](double n) {  // where the total first passes 1
        double degrees = 45;
        const auto excess = [&](double c) { return schlick(0.04, c) * phong_albedo(n, c) - 0.04; };
        while (excess(cos_of_degrees(degrees)) < 0) {
            degrees += 0.01;
        }
        return degrees;
    };
    CHECK(std::abs(onset(1) - 58.6) < 0.05);
    CHECK(std::abs(onset(10) - 63) < 0.5);
    CHECK(std::abs(onset(1000) - 63) < 0.5);
}

TEST_CASE("by the slides' own rule, Cd' + F(theta) <= 1, it fails far more") {
    CHECK(std::abs(0.96 + schlick(0.04, cos_of_degrees(85)) - 1.61) < 5e-3);
}

TEST_CASE("the ambient term is the radiance that constant light from everywhere makes") {
    for (const double F0 : {0.0, 0.04, 0.5}) {
        for (const double degrees : {0.0, 60.0, 85.0}) {
            for (const bool by_angle : {false, true}) {
                const double c = cos_of_degrees(degrees);
                const double measured = directional_albedo(Diffuse{F0, by_angle}, c, Fixed::view).g;
                const Remains remains = by_angle ? Remains::by_angle : Remains::by_f0;
                const auto ambient = white(static_cast<float>(F0), 10, remains).ambient_albedo();
                CHECK(std::abs(measured - double{ambient.g}) < 1e-6);
            }
        }
    }
    CHECK(white(0.04F, 10, Remains::all).ambient_albedo().g == 1);
}

TEST_CASE("the curve that the picture looks up is the measured one") {
    const Combined brdf = white(0.04F, 10, Remains::by_f0);
    const AlbedoCurve curve(brdf);
    for (const double c : {0.01, 0.1, 0.4, 0.77, 1.0}) {
        CHECK(std::abs(curve(c) - directional_albedo(brdf, c).g) < 1e-3);
        CHECK(std::abs(value(curve(Float8(static_cast<float>(c)))) - curve(c)) < 1e-6);
    }
}

TEST_CASE_TEMPLATE("14 in every number type", T, float, ALL_LANES) {
    std::mt19937 random(14);
    std::uniform_real_distribution<float> cosine(0, 1);
    for (int i = 0; i < 1000; ++i) {
        const float NL = cosine(random);
        const float NV = cosine(random);
        const float LV = cosine(random);
        const float n = 100 * cosine(random);
        const float F0 = cosine(random);
        for (const Remains remains : {Remains::all, Remains::by_angle, Remains::by_f0}) {
            const Combined brdf = white(F0, n, remains);
            const double exact = brdf(Incidence<double>{double{NL}, double{NV}, double{LV}}).g;
            const double got = value(brdf(Incidence<T>{T(NL), T(NV), T(LV)}).g);
            const double VR = 2.0 * double{NL} * double{NV} - double{LV};
            // V.R is off by some 1e-7, which its power multiplies by n / (V.R).
            const double condition = VR > 0.3 ? 4 + double{n} / VR : 30;
            REQUIRE(std::abs(got - exact) < 2.5e-7 * condition * (1 + exact));
        }
    }
}

TEST_CASE_TEMPLATE("14 at its ends", T, float, double, ALL_LANES) {
    const auto at = [](float NL, float NV, float LV, float F0, float n, Remains remains) {
        return value(white(F0, n, remains)(Incidence<T>{T(NL), T(NV), T(LV)}).g);
    };
    for (const float n : {0.0F, 0.5F, 1.0F, 1e3F, 1e6F}) {
        const double peak = (double{n} + 2) / (2 * pi);
        for (const Remains remains : {Remains::all, Remains::by_angle, Remains::by_f0}) {
            CAPTURE(n);
            // L = V = N with F0 = 1: what is left is the mirror's lobe.
            const double diffuse = remains == Remains::all ? 1 / pi : 0;
            CHECK(at(1, 1, 1, 1, n, remains) == doctest::Approx(diffuse + peak).epsilon(1e-6));
            // F0 = 0: all diffuse.
            CHECK(at(1, 1, 1, 0, n, remains) == doctest::Approx(1 / pi).epsilon(1e-6));
            // V.R < 0 and the viewer below the horizon: no highlight.
            CHECK(at(0.5F, -0.5F, 0.2F, 0, n, remains) <= 1 / pi + 1e-6);
            for (const float c : {0.0F, 1e-8F}) {  // grazing light: F = 1
                const double left = remains == Remains::by_angle ? 0 : 1 / pi;
                CHECK(at(c, c, -1, 0, n, remains) == doctest::Approx(left + peak).epsilon(1e-5));
            }
            for (const float odd : {nan, infinity, -infinity}) {
                CHECK(std::isfinite(at(odd, 0.5F, 0.5F, 0.04F, n, remains)));
            }
        }
    }
}

}  // namespace
}  // namespace glint
