#include "lessons/04_rendering_equation/rendering_equation.hpp"
#include "lessons/08_normalised_lambert/normalised_lambert.hpp"
#include "framework/measure/gonioreflectometer.hpp"
#include "tests/unit/lessons/lane_value.hpp"

#include <doctest/doctest.h>

namespace glint {
namespace {

const Rgb<float> some_colour(0.125F, 0.5F, 1.0F);

double difference(const Rgb<double>& a, const Rgb<double>& b) {
    return length(a - b);
}

TEST_CASE("08.1 with 1/pi the albedo is Cd at every angle; without it, pi Cd") {
    const LambertPhong without{some_colour, Rgb<float>(0.0F), 1};
    for (const double degrees : {0.0, 30.0, 60.0, 80.0, 89.0, 89.9999}) {
        for (const Fixed fixed : {Fixed::light, Fixed::view}) {
            CAPTURE(degrees);
            const double c = cos_of_degrees(degrees);
            const Rgb<double> Cd(some_colour);
            CHECK(difference(directional_albedo(NormalisedLambert{some_colour}, c, fixed), Cd) <
                  1e-8);
            CHECK(difference(directional_albedo(without, c, fixed), pi * Cd) < pi * 1e-8);
        }
    }
}

TEST_CASE("08.1 it is reciprocal") {
    const NormalisedLambert brdf{some_colour};
    for (const double a : {0.0, 0.5, 1.5}) {
        for (const double b : {0.1, 1.0, 1.5}) {
            CHECK(reciprocity_error(brdf, incidence_of_angles(a, b, 2.0)) == Rgb<double>(0.0));
        }
    }
}

TEST_CASE_TEMPLATE("08.1 Cd/pi in every number type, whatever the directions are", T, float, double,
                   ALL_LANES) {
    const double inv_pi = 0.318309886183790671538;
    const double ulp = std::same_as<T, double> ? 1e-16 : 0x1p-24;
    CHECK(value(T(inverse_pi<T>)) == doctest::Approx(inv_pi).epsilon(ulp));
    for (const float x : {1.0F, 1e-8F, 0.0F, -1.0F, infinity, nan}) {
        const Rgb<T> f = NormalisedLambert{some_colour}(Incidence<T>{T(x), T(x), T(x)});
        CHECK(value(f.r) == doctest::Approx(0.125 * inv_pi).epsilon(2 * ulp));
        CHECK(value(f.g) == doctest::Approx(0.5 * inv_pi).epsilon(2 * ulp));
        CHECK(value(f.b) == doctest::Approx(inv_pi).epsilon(2 * ulp));
    }
    const Rgb<T> none = NormalisedLambert{Rgb<float>(0.0F)}(Incidence<T>{T(1), T(1), T(1)});
    CHECK(value(none.g) == 0);
}

TEST_CASE("08.2 constant light is reflected by the integral of the BRDF") {
    const NormalisedLambert brdf{some_colour};
    const Rgb<double> integral = directional_albedo(brdf, 1.0, Fixed::view);
    CHECK(difference(Rgb<double>(brdf.ambient_albedo()), integral) < 1e-8);
}

TEST_CASE("08 white that faces a lamp of irradiance pi shows radiance 1") {
    const Lit<NormalisedLambert> white{
        {Rgb<float>(1.0F)},
        {.directional = {{{0, 0, 1}, Rgb<float>(std::numbers::pi_v<float>)}}, .point = {}},
        {5, 0, 5}};
    const Rgb<double> L = white(Lit<NormalisedLambert>::Varyings<double>{{0, 0, 0}, {0, 0, 1}});
    CHECK(difference(L, Rgb<double>(1.0)) < 1e-7);
}

}  // namespace
}  // namespace glint
