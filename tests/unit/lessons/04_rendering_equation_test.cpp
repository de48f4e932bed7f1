#include "lessons/04_rendering_equation/rendering_equation.hpp"
#include "lessons/04_rendering_equation/sky.hpp"
#include "framework/measure/gonioreflectometer.hpp"
#include "tests/unit/lessons/lane_value.hpp"
#include "tests/worst.hpp"

#include <doctest/doctest.h>

namespace glint {
namespace {

const glm::vec3 up(0, 1, 0);
const TwoTones constant{Rgb<float>(1.0F), Rgb<float>(1.0F)};
const TwoTones sky{Rgb<float>(0.5F, 1.0F, 2.0F), Rgb<float>(0.5F, 0.25F, 0.0F)};

Lighting lamps(const TwoTones& around, int count) {
    Lighting all;
    for (const glm::vec3& L : sphere_directions(count)) {
        all.directional.push_back(lamp_of(around, L, static_cast<float>(4 * pi / count)));
    }
    return all;
}

// Matt white, seen from where no direction of the tests is below it.
template <class T>
Rgb<double> radiance(const Lighting& lighting, const glm::vec3& normal, float Cd = 1) {
    const Lit<UnnormalisedLambert> shader{{Rgb<float>(Cd)}, lighting, {3, 3, 3}};
    const auto in = Lit<UnnormalisedLambert>::Varyings<T>{Vec3<T>(T(0.0F)), Vec3<T>(normal)};
    const Rgb<T> c = shader(in);
    return {value(c.r), value(c.g), value(c.b)};
}

// The worst relative error of the sum over count directions, over 10,000 normals.
double worst_error(const TwoTones& around, int count) {
    const Lighting lighting = lamps(around, count);
    double worst = 0;
    for (const glm::vec3& N : sphere_directions(10000)) {
        const Rgb<double> exact = around.irradiance(Vec3<double>(N));
        worst = worse(worst, std::abs(radiance<double>(lighting, N).g / exact.g - 1));
    }
    return worst;
}

TEST_CASE("04.1 the sum over lights is the sum of what each makes alone") {
    const DirectionalLight a{normalize(glm::vec3(1, 2, 0)), Rgb<float>(1, 2, 3)};
    const DirectionalLight b{normalize(glm::vec3(-1, 1, 1)), Rgb<float>(3, 1, 0.5F)};
    const PointLight c{{0, 2, 0}, Rgb<float>(4.0F)};
    const Rgb<double> all = radiance<double>({{a, b}, {c}, Rgb<float>(0.0F)}, up);
    const Rgb<double> sum = radiance<double>({{a}, {}, Rgb<float>(0.0F)}, up) +
                            radiance<double>({{b}, {}, Rgb<float>(0.0F)}, up) +
                            radiance<double>({{}, {c}, Rgb<float>(0.0F)}, up);
    CHECK(length(all - sum) < 1e-14);
    const Rgb<double> by_hand = Rgb<double>(1, 2, 3) * double{a.direction.y} +
                                Rgb<double>(3, 1, 0.5) * double{b.direction.y} + 1.0;
    CHECK(length(all - by_hand) < 1e-7);
}

TEST_CASE("04.1 ambient light is added to it, once") {
    const Rgb<double> alone = radiance<double>({{}, {}, Rgb<float>(0.5F)}, up, 0.25F);
    CHECK(length(alone - Rgb<double>(0.125 * pi)) < 1e-7);
    const DirectionalLight lamp{up, Rgb<float>(1.0F)};
    const Rgb<double> both = radiance<double>({{lamp, lamp}, {}, Rgb<float>(0.5F)}, up, 0.25F);
    CHECK(length(both - alone - Rgb<double>(0.5)) < 1e-12);
}

TEST_CASE("04.2 a lamp is radiance times solid angle") {
    const DirectionalLight lamp = lamp_of(sky, up, 0.5F);
    CHECK(lamp.direction == up);
    CHECK(lamp.irradiance == Rgb<float>(0.25F, 0.5F, 1.0F));
    CHECK(lamp_of(sky, -up, 2.0F).irradiance == Rgb<float>(1.0F, 0.5F, 0.0F));
}

TEST_CASE("04.2 the sum tends to the integral: the README's table") {
    constexpr int counts[] = {4, 16, 64, 256, 1024, 4096};
    constexpr double of_constant[] = {.4649, .08166, .01571, .002597, .0004819, .0000695};
    constexpr double of_sky[] = {1.315, .4434, .08384, .01981, .004594, .001047};
    for (int i = 0; i < 6; ++i) {
        CAPTURE(counts[i]);
        CHECK(std::abs(worst_error(constant, counts[i]) / of_constant[i] - 1) < 0.005);
        CHECK(std::abs(worst_error(sky_and_ground, counts[i]) / of_sky[i] - 1) < 0.005);
    }
}

TEST_CASE("the directions are of unit length and fill the sphere evenly") {
    for (const int count : {1, 2, 4, 1000}) {
        glm::dvec3 sum(0);
        for (const glm::vec3& d : sphere_directions(count)) {
            CHECK(std::abs(length(d) - 1) < 1e-6F);
            sum += glm::dvec3(d);
        }
        CHECK(length(sum) <= (count < 4 ? 1.0 : 0.25 * count));
        CHECK(static_cast<int>(sphere_directions(count).size()) == count);
    }
    CHECK(sphere_directions(0).empty());
}

// By lesson 2's integral in polar coordinates about N.
TEST_CASE("the closed form of a sky of two tones") {
    const Quadrature rule = gauss_legendre(64);
    for (const double tilt : {0.0, 0.4, 1.0, pi / 2, 2.5, pi}) {
        // At theta from N the horizon leaves a part of the ring above it.
        const double above = integrate(rule, 0, pi / 2, [&](double theta) {
            const double c = -1 / std::tan(tilt) / std::tan(theta);
            const double half = tilt == 0 ? pi : std::acos(std::clamp(c, -1.0, 1.0));
            return 2 * half * std::cos(theta) * std::sin(theta);
        });
        const Vec3<double> N(std::sin(tilt), std::cos(tilt), 0);
        const double expected = above + 0.25 * (pi - above);
        CHECK(std::abs(sky.irradiance(N).g - expected) < 2e-3);
    }
}

TEST_CASE("04.3 the ambient term is the integral of constant light") {
    const UnnormalisedLambert matt{Rgb<float>(0.25F, 0.5F, 1.0F)};
    const Rgb<double> integral = directional_albedo(matt, 0.7, Fixed::view);
    CHECK(length(Rgb<double>(matt.ambient_albedo()) - integral) < 1e-6);
    const Rgb<double> by_sum =
        radiance<double>(lamps(constant, 4096), normalize(glm::vec3(1, 2, 3)));
    const Rgb<double> by_term = radiance<double>({{}, {}, Rgb<float>(1.0F)}, up);
    CHECK(length(by_sum - by_term) < 1e-2);
    CHECK(std::abs(by_term.g - 3.1416) < 5e-5);  // lesson 1 guessed 1
}

TEST_CASE_TEMPLATE("04 in every number type", T, float, ALL_LANES) {
    for (const int count : {0, 1, 4, 64, 1024}) {
        Lighting lighting = lamps(sky, count);
        lighting.point = {{{1, 4, -2}, Rgb<float>(3.0F)}};
        lighting.ambient = Rgb<float>(0.1F);
        for (const glm::vec3& N : sphere_directions(9)) {
            const Rgb<double> exact = radiance<double>(lighting, N);
            CHECK(length(radiance<T>(lighting, N) - exact) < 1e-5 * (1 + length(exact)));
        }
    }
}

TEST_CASE_TEMPLATE("04 at its ends", T, float, double, ALL_LANES) {
    Lighting lighting = lamps(constant, 16);
    lighting.ambient = Rgb<float>(0.5F);
    for (const glm::vec3 none : {glm::vec3(0), glm::vec3(nan), glm::vec3(infinity)}) {
        CHECK(std::abs(radiance<T>(lighting, none).g - pi / 2) < 1e-6);  // ambient light only
    }
    for (const double NL : {1.0, 1e-8, 0.0, -1e-8, -1.0}) {
        const auto across = static_cast<float>(std::sqrt(1 - NL * NL));
        const DirectionalLight lamp{{across, static_cast<float>(NL), 0}, Rgb<float>(2.0F)};
        const double found = radiance<T>({{lamp}, {}, Rgb<float>(0.0F)}, up).g;
        CHECK(std::abs(found - 2 * std::max(NL, 0.0)) <= 1e-7 * std::max(NL, 0.0));
    }
    const PointLight here{{0, 0, 0}, Rgb<float>(1.0F)};  // in the light's own place nothing arrives
    CHECK(radiance<T>({{}, {here}, Rgb<float>(0.0F)}, up).g == 0);
    CHECK(radiance<T>({{{-up, Rgb<float>(5.0F)}}, {}, Rgb<float>(0.0F)}, up).g ==
          0);  // from behind
}

}  // namespace
}  // namespace glint
