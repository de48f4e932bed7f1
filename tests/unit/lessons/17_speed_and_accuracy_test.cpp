#include "lessons/17_speed_and_accuracy/thrifty_brdf.hpp"
#include "framework/measure/gonioreflectometer.hpp"
#include "tests/unit/lessons/lane_value.hpp"
#include "tests/worst.hpp"

#include <doctest/doctest.h>

#include <numbers>

namespace glint {
namespace {

constexpr double pi = std::numbers::pi;

const Material gold{.name = "gold", .diffuse = Rgb<float>(0.0F), .exponent = 40.5F};
const Material glaze{.name = "glaze", .specular = Rgb<float>(0.05F), .exponent = 120.5F};

TEST_CASE("17.1 errors are counted in codes") {
    for (int code = 0; code < 255; ++code) {
        const double one_code_apart =
            code_error(srgb_decode(code / 255.0), srgb_decode((code + 1) / 255.0));
        CHECK(one_code_apart == doctest::Approx(1));
    }
    CHECK(code_error(0.25, 0.25) == 0);
    CHECK(code_error(5, 1) == 0);  // both are white
    CHECK(code_error(-1, 0) == 0);
    CHECK(code_error(0, 2) == doctest::Approx(255));
    CHECK(code_error(0.2, 0.4) == code_error(0.4, 0.2));
}

TEST_CASE("17.2 the cheapest that is near enough") {
    const Method methods[] = {{10, 0.01}, {4, 0.3}, {3, 2}, {3, 1}, {20, 0.005}};
    CHECK(cheapest(methods, 4) == 2);
    CHECK(cheapest(methods, 2) == 2);  // the tolerance itself is within it
    CHECK(cheapest(methods, 1.5) == 3);
    CHECK(cheapest(methods, 0.5) == 1);
    CHECK(cheapest(methods, 0.1) == 0);
    CHECK(cheapest(methods, 0.006) == 4);
    CHECK(cheapest(methods, 0.001) == 4);  // none: the most accurate
    CHECK(cheapest(std::span(methods, 1), 0) == 0);
}

TEST_CASE_TEMPLATE("17.3 each form is that of its lesson", T, float, double, ALL_LANES) {
    const Surface s = surface_of(gold);
    for (const float c : {0.0F, 0.02F, 0.3F, 0.8F, 1.0F}) {
        const T cosine(c);
        for (int band = 0; band < 3; ++band) {
            const double ior = double{s.ior[band]};
            const double k = double{s.k[band]};
            const double F0 = double{s.F0[band]};
            const auto near = [&](Fresnel form, double expected) {
                const double got = value(reflectance(form, s, cosine)[band]);
                CHECK(got == doctest::Approx(expected).epsilon(2e-6));
            };
            near(Fresnel::exact, fresnel_conductor(ior, k, double{c}).unpolarised);
            near(Fresnel::schlick, schlick(F0, double{c}));
            near(Fresnel::lazanyi, lazanyi(F0, double{s.dip[band]}, double{c}));
            near(Fresnel::f0, F0);
        }
    }
}

TEST_CASE("17 what a surface is") {
    const Surface metal = surface_of(gold);
    CHECK(metal.ior == metals[0].ior);
    CHECK(metal.k == metals[0].k);
    CHECK(metal.F0.r == doctest::Approx(double{f0_conductor(0.1556F, 3.6024F)}));
    const Surface dielectric = surface_of(glaze);
    CHECK(dielectric.k == Rgb<float>(0.0F));
    CHECK(dielectric.F0.g == doctest::Approx(0.05));
    CHECK(dielectric.ior.g == doctest::Approx(1.57601));
    const Surface mirror = surface_of({.specular = Rgb<float>(1.0F)});
    CHECK(std::isfinite(mirror.ior.r));
    CHECK(std::isfinite(mirror.dip.r));
}

TEST_CASE("17 what reflects nothing has no highlight") {
    Lighting lights;
    lights.directional = {{{0, 0, 1}, {1, 1, 1}}};
    const Surface black = surface_of({.specular = Rgb<float>(0.0F)});
    CHECK(highlight_from(black, lights, 0) > 1);
    const Surface s = surface_of(glaze);
    CHECK(highlight_from(s, lights, 0) < -1);
    CHECK(highlight_from(s, lights, 1e-3F) ==
          highlight_from(EnginePhong{s.Cd, s.F0, s.n}, lights, 1e-3F));
    const Incidence<double> mirror = incidence_of_angles(0.5, 0.5, pi);
    const ThriftyPhong exact{black, Fresnel::exact, false, -2};
    const ThriftyPhong without{black, Fresnel::exact, false, highlight_from(black, lights, 0)};
    CHECK(exact(mirror) == without(mirror));
}

TEST_CASE_TEMPLATE("17 four terms are off by no more than is said", T, float, ALL_LANES) {
    for (const float n : {0.5F, 3.3F, 40.5F, 150.5F, 1e4F}) {
        double worst = 0;
        for (int i = 0; i <= 2000; ++i) {
            const float x = std::exp2(-14 * static_cast<float>(i) / (2000 * n));
            const double got = value(short_pow(T(x), T(n)));
            worst = worse(worst, code_error(got, std::pow(double{x}, double{n})));
        }
        CHECK(worst < 0.045 + 2e-6 * double{n});  // x is rounded, too
        CHECK(worst > 0.01);
        CHECK(value(short_pow(T(1e-37F), T(n))) < 1e-5F);
        CHECK(value(short_pow(T(1.0F), T(n))) == doctest::Approx(1).epsilon(2e-4));
    }
}

TEST_CASE_TEMPLATE("17 the whole, in every form, near lesson 15's", T, float, double, Float8) {
    const Surface s = surface_of(glaze);
    const EnginePhong engine{s.Cd, s.F0, s.n};
    for (const double theta : {0.1, 0.7, 1.2}) {
        const Incidence<double> d = incidence_of_angles(theta, 0.6, pi);
        const Incidence<T> g{T(static_cast<float>(d.NL)), T(static_cast<float>(d.NV)),
                             T(static_cast<float>(d.LV))};
        const double expected = engine(d).g;
        const auto with = [&](Fresnel form, bool few_terms, float from) {
            return value(ThriftyPhong{s, form, few_terms, from}(g).g);
        };
        CHECK(with(Fresnel::schlick, false, -2) == doctest::Approx(expected).epsilon(3e-5));
        CHECK(with(Fresnel::schlick, true, -2) == doctest::Approx(expected).epsilon(1e-3));
        CHECK(with(Fresnel::exact, false, -2) == doctest::Approx(expected).epsilon(0.05));
        const double diffuse = double{s.Cd.g} * (1 - double{s.F0.g}) / pi;
        CHECK(with(Fresnel::schlick, false, 2) == doctest::Approx(diffuse).epsilon(1e-6));
    }
    CHECK(ThriftyPhong{s, Fresnel::exact, true, 0}.ambient_albedo() == engine.ambient_albedo());
}

TEST_CASE_TEMPLATE("17 at its ends", T, float, double, ALL_LANES) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const Material& m : {gold, glaze}) {
        for (const float n : {0.0F, 0.5F, 1.0F, 1e3F, 1e6F}) {
            Surface s = surface_of(m);
            s.n = n;
            for (const bool few_terms : {false, true}) {
                const ThriftyPhong brdf{s, Fresnel::exact, few_terms, -2};
                for (const glm::vec3& c : {glm::vec3(0, 0, 1), glm::vec3(1e-8F, 0.5F, -0.5F),
                                           glm::vec3(1, 1, 1), glm::vec3(0.5F, -0.5F, -1)}) {
                    const double f = value(brdf(Incidence<T>{T(c.x), T(c.y), T(c.z)}).r);
                    CHECK(std::isfinite(f));
                    CHECK(f >= 0);
                }
            }
        }
        const ThriftyPhong brdf{surface_of(m), Fresnel::f0, true, 0.5F};
        const auto f = brdf(Incidence<T>{T(nan), T(nan), T(nan)});
        CHECK(value(f.r) == value(diffuse_by_f0(Rgb<T>(m.diffuse), Rgb<T>(surface_of(m).F0)).r));
    }
}

}  // namespace
}  // namespace glint
