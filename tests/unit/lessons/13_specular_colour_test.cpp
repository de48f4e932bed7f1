#include "lessons/12_schlick/schlick.hpp"
#include "lessons/13_specular_colour/specular_colour.hpp"
#include "tests/unit/lessons/lane_value.hpp"

#include <doctest/doctest.h>

namespace glint {
namespace {

const SpecularColour& colour(std::string_view name) {
    for (const SpecularColour& c : specular_colours) {
        if (c.name == name) {
            return c;
        }
    }
    throw std::string(name);
}

// IEC 61966-2-1, rounded to two digits.
double two_digits_of_code(float linear) {
    return std::round(100 * srgb_encode(double{linear})) / 100;
}

TEST_CASE("the table's sRGB column, computed anew") {
    constexpr double expected[10][3] = {
        {.15, .15, .15}, {.19, .19, .19}, {.25, .25, .25}, {.31, .31, .31}, {.45, .45, .45},
        {.77, .78, .79}, {.98, .82, .76}, {1.0, .86, .57}, {.96, .96, .96}, {.98, .97, .95}};
    for (std::size_t i = 0; i < specular_colours.size(); ++i) {
        for (int band = 0; band < 3; ++band) {
            CAPTURE(specular_colours[i].name);
            CAPTURE(band);
            CHECK(two_digits_of_code(specular_colours[i].F0[band]) ==
                  doctest::Approx(expected[i][band]).epsilon(1e-12));
        }
    }
}

TEST_CASE("the four entries that the slides print otherwise, to four digits") {
    const auto code = [](double linear) { return srgb_encode(linear); };
    CHECK(std::abs(code(0.03) - 0.1897) < 5e-5);  // printed 0.21
    CHECK(std::abs(code(0.05) - 0.2478) < 5e-5);  // printed 0.24
    CHECK(std::abs(code(0.58) - 0.7858) < 5e-5);  // printed 0.78
    CHECK(std::abs(code(0.92) - 0.9640) < 5e-5);  // printed 0.97, beside an equal 0.96
    // A gamma of 2.2 does not explain them.
    const auto gamma = [](double linear) { return std::pow(linear, 1 / 2.2); };
    CHECK(std::abs(gamma(0.03) - 0.203) < 5e-4);
    CHECK(std::abs(gamma(0.05) - 0.256) < 5e-4);
    CHECK(std::abs(gamma(0.58) - 0.781) < 5e-4);
    CHECK(std::abs(gamma(0.92) - 0.963) < 5e-4);
}

TEST_CASE("the linear column is physics for dielectrics") {
    CHECK(std::abs(f0_dielectric(1.333) - double{colour("water").F0.r}) < 0.005);
    CHECK(std::abs(f0_dielectric(1.77) - double{colour("glass, high, or ruby").F0.r}) < 0.005);
    CHECK(std::abs(f0_dielectric(2.417) - double{colour("diamond").F0.r}) < 0.005);
    CHECK(f0_dielectric(1.5) > double{colour("plastic or glass, low").F0.r});
    CHECK(f0_dielectric(1.5) < double{colour("plastic, high").F0.r});
    for (const SpecularColour& c : specular_colours) {
        const bool grey = c.F0.r == c.F0.g && c.F0.g == c.F0.b;
        CHECK((grey || c.metal));
        CHECK((c.metal ? c.F0.r > 0.5F : c.F0.r < 0.2F));
    }
}

TEST_CASE("13.1 metals have no diffuse reflection, dielectrics keep theirs") {
    const Rgb<float> Cd(0.1F, 0.5F, 1.0F);
    CHECK(diffuse_albedo(Cd, true) == Rgb<float>(0.0F));
    CHECK(diffuse_albedo(Cd, false) == Cd);
    // Without this 1 - F0 would leave gold 71 % of its blue diffuse colour.
    CHECK(1 - colour("gold").F0.b == doctest::Approx(0.71));
}

TEST_CASE("13.2 from codes to reflectances and back") {
    for (const SpecularColour& c : specular_colours) {
        Rgb<float> codes;
        for (int band = 0; band < 3; ++band) {
            codes[band] = static_cast<float>(srgb_encode(double{c.F0[band]}));
        }
        const Rgb<float> back = f0_from_srgb(codes);
        for (int band = 0; band < 3; ++band) {
            CHECK(back[band] == doctest::Approx(c.F0[band]).epsilon(1e-6));
        }
    }
    CHECK(f0_from_srgb(Rgb<float>(0.0F)) == Rgb<float>(0.0F));
    CHECK(f0_from_srgb(Rgb<float>(1.0F)) == Rgb<float>(1.0F));
    CHECK(f0_from_srgb(Rgb<float>(0.5F)).r == doctest::Approx(0.21404));
    CHECK(f0_from_srgb(Rgb<float>(0.02F)).r == doctest::Approx(0.02 / 12.92));  // the straight part
}

TEST_CASE("what the mistake does: too bright by factors, and pale") {
    CHECK(srgb_encode(0.02) / 0.02 == doctest::Approx(7.6).epsilon(0.005));
    CHECK(std::abs(srgb_encode(0.02) - double{colour("diamond").F0.r}) < 0.02);
    CHECK(srgb_encode(0.17) / 0.17 == doctest::Approx(2.65).epsilon(0.005));
    CHECK(srgb_encode(0.29) / 0.29 == doctest::Approx(1.98).epsilon(0.005));  // gold's blue
    CHECK(srgb_encode(0.71) / 0.71 == doctest::Approx(1.21).epsilon(0.005));  // gold's green
}

TEST_CASE_TEMPLATE("F0 as a colour in every number type", T, float, ALL_LANES) {
    for (const SpecularColour& c : specular_colours) {
        for (const float cosine : {0.0F, 1e-8F, 0.3F, 1.0F}) {
            const Rgb<T> F = schlick(Rgb<T>(c.F0), T(cosine));
            const Rgb<double> exact = schlick(Rgb<double>(c.F0), double{cosine});
            for (int band = 0; band < 3; ++band) {
                CHECK(std::abs(value(F[band]) - exact[band]) < 1e-6);
            }
        }
    }
}

}  // namespace
}  // namespace glint
