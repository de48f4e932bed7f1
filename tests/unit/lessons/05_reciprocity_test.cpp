#include "lessons/01_ad_hoc_phong/ad_hoc_phong.hpp"
#include "lessons/05_reciprocity/reciprocity.hpp"
#include "framework/measure/gonioreflectometer.hpp"
#include "tests/unit/lessons/lane_value.hpp"

#include <doctest/doctest.h>

namespace glint {
namespace {

// Light and viewer at so many degrees from the normal, across from each other.
Incidence<double> across(double light, double viewer) {
    return {cos_of_degrees(light), cos_of_degrees(viewer), cos_of_degrees(light + viewer)};
}

template <class Brdf>
double ratio(const Brdf& brdf, const Incidence<double>& g) {
    return brdf(g).g / brdf(swapped(g)).g;
}

TEST_CASE_TEMPLATE("05.1 light and viewer change places", T, float, double, ALL_LANES) {
    const Incidence<T> g = swapped(Incidence<T>{T(0.25F), T(0.5F), T(-0.75F)});
    CHECK(value(g.NL) == 0.5);
    CHECK(value(g.NV) == 0.25);
    CHECK(value(g.LV) == -0.75);
    const Incidence<T> back = swapped(g);
    CHECK(value(back.NL) == 0.25);
    CHECK(value(back.NV) == 0.5);
}

TEST_CASE("05.1 by vectors") {
    const Vec3<double> N(0, 0, 1);
    const Vec3<double> L = normalize(Vec3<double>(1, 2, 3));
    const Vec3<double> V = normalize(Vec3<double>(-2, 0.5, 1));
    const Incidence<double> by_vectors = incidence(N, V, L);
    const Incidence<double> by_swap = swapped(incidence(N, L, V));
    CHECK(by_vectors.NL == by_swap.NL);
    CHECK(by_vectors.NV == by_swap.NV);
    CHECK(by_vectors.LV == by_swap.LV);
}

TEST_CASE("the instrument measures f(L,V) - f(V,L)") {
    const ClassicPhong brdf{4};
    const auto g = incidence_of_angles(1.2, 0.5, 2.5);
    CHECK(reciprocity_error(brdf, g) == brdf(g) - brdf(swapped(g)));
    CHECK(reciprocity_error(brdf, g).g > 0);
}

TEST_CASE("05.2 the classic highlight as a BRDF: the README's table") {
    for (const float n : {0.5F, 3.0F, 100.0F}) {
        const ClassicPhong classic{n};
        CHECK(std::abs(ratio(classic, across(45, 0)) - 1.41) < 5e-3);
        CHECK(std::abs(ratio(classic, across(60, 30)) - 1.73) < 5e-3);
        CHECK(std::abs(ratio(classic, across(80, 60)) - 2.88) < 5e-3);
        CHECK(std::abs(ratio(classic, across(89, 60)) - 28.6) < 5e-2);
        CHECK(std::abs(ratio(classic, across(50, 50)) - 1) < 1e-12);
        CHECK(ratio(PhongLobe{n}, across(80, 60)) == 1);
        CHECK(ratio(PhongLobe{n}, across(89, 60)) == 1);
    }
    CHECK(std::abs(ClassicPhong{3}(across(89, 89)).g - 57.3) < 5e-2);  // 1 / cos
}

// By lesson 1's own shader: radiance over irradiance.
TEST_CASE("05.2 it is what lesson 1 draws") {
    const Material shiny{.diffuse = Rgb<float>(0.0F), .specular = Rgb<float>(1.0F), .exponent = 3};
    for (const double degrees : {0.0, 40.0, 80.0, 89.0}) {
        const glm::vec3 L(std::sin(degrees * pi / 180), 0, cos_of_degrees(degrees));
        const AdHocPhong shader{shiny, {{{L, Rgb<float>(2.0F)}}, {}, Rgb<float>(0.0F)}, {-4, 0, 3}};
        const double radiance =
            shader(AdHocPhong::Varyings<double>{{0, 0, 0}, {0, 0, 1}}, Silent{}).g;
        const auto g =
            incidence(Vec3<double>(0, 0, 1), Vec3<double>(L), Vec3<double>(-0.8, 0, 0.6));
        CHECK(ClassicPhong{3}(g).g == doctest::Approx(radiance / (2 * g.NL)).epsilon(1e-6));
    }
}

TEST_CASE("05.2 it grows without bound towards the horizon, and is 0 below") {
    double before = 0;
    for (const double NL : {1e-1, 1e-2, 1e-4, 1e-8}) {
        const double f = ClassicPhong{3}(Incidence<double>{NL, NL, 2 * NL * NL - 1}).g;
        CHECK(f * NL == doctest::Approx(1));
        CHECK(f > 9 * before);
        before = f;
    }
}

TEST_CASE_TEMPLATE("the lobe is reciprocal to the bit", T, float, double, ALL_LANES) {
    for (const float n : {0.0F, 0.5F, 1.0F, 1e3F, 1e6F}) {
        for (const double light : {0.0, 0.5, 1.0, 1.57}) {
            for (const double viewer : {0.1, 0.7, 1.3, 1.5707}) {
                for (const double azimuth : {0.0, 2.0, pi}) {
                    const auto g = incidence_of_angles(light, viewer, azimuth);
                    const Incidence<T> in{T(g.NL), T(g.NV), T(g.LV)};
                    CHECK(value(reciprocity_error(PhongLobe{n}, in).g) == 0);
                }
            }
        }
    }
}

TEST_CASE_TEMPLATE("05.2 in every number type", T, float, ALL_LANES) {
    for (const float n : {0.0F, 0.5F, 1.0F, 50.0F, 1e3F}) {
        for (const double light : {0.0, 0.5, 1.0, 1.5}) {
            for (const double viewer : {0.1, 0.7, 1.3}) {
                const auto g = incidence_of_angles(light, viewer, 3.0);
                const Incidence<float> f{float(g.NL), float(g.NV), float(g.LV)};
                const double exact =
                    ClassicPhong{n}(Incidence<double>{double{f.NL}, double{f.NV}, double{f.LV}}).g;
                const double found =
                    value(ClassicPhong{n}(Incidence<T>{T(f.NL), T(f.NV), T(f.LV)}).g);
                CHECK(std::abs(found - exact) <= (4 + double{n}) * 1e-6 * (exact + 0.01));
            }
        }
    }
}

TEST_CASE_TEMPLATE("05 at its ends", T, float, double, ALL_LANES) {
    const auto classic = [](double NL, double NV, double LV, float n) {
        return value(ClassicPhong{n}(Incidence<T>{T(NL), T(NV), T(LV)}).g);
    };
    for (const float n : {0.0F, 0.5F, 1.0F, 1e3F, 1e6F}) {
        CHECK(classic(1, 1, 1, n) == 1);  // L = V = N
        for (const double below : {0.0, -1e-8, -0.5, -1.0, double{nan}}) {
            CHECK(classic(below, 0.5, 0.5, n) == 0);
        }
        CHECK(classic(0.5, 0.5, 1, n) == 0);     // V.R < 0
        CHECK(classic(1e-8, 0.5, 0.5, n) == 0);  // V.R < 0 at the horizon: 0, not NaN
        CHECK(classic(0.5, double{nan}, 0, n) == 0);
    }
}

}  // namespace
}  // namespace glint
