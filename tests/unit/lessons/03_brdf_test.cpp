#include "lessons/01_ad_hoc_phong/ad_hoc_phong.hpp"
#include "lessons/03_brdf/brdf.hpp"
#include "framework/measure/gonioreflectometer.hpp"
#include "tests/unit/lessons/lane_value.hpp"

#include <doctest/doctest.h>

namespace glint {
namespace {

// Angles from the normal in degrees, in one plane; below 0 is on the other side.
Incidence<double> at(double light, double view) {
    return {cos_of_degrees(light), cos_of_degrees(view), cos_of_degrees(light - view)};
}

template <class T>
double lobe(const Incidence<double>& g, double n) {
    return value(phong_lobe(Incidence<T>{T(g.NL), T(g.NV), T(g.LV)}, T(n)));
}

TEST_CASE("03.1 Lambert's BRDF is its constant, wherever the light is") {
    CHECK(lambert_unnormalised(Rgb<float>(0.1F, 0.5F, 1.0F)) == Rgb<float>(0.1F, 0.5F, 1.0F));
    const LambertPhong matt{Rgb<float>(0.1F, 0.5F, 1.0F), Rgb<float>(0.0F), 10};
    CHECK(matt(at(0, 0)) == Rgb<double>(Rgb<float>(0.1F, 0.5F, 1.0F)));
    CHECK(matt(at(89, -40)) == matt(at(0, 0)));
}

TEST_CASE("03.2 the lobe is the n-th power of the cosine to the mirror direction") {
    for (const double n : {0.0, 0.5, 1.0, 2.0, 10.0, 1e3, 1e6}) {
        for (const double apart : {0.0, 0.05, 1.0, 20.0, 60.0, 89.0}) {
            const double exact = std::pow(cos_of_degrees(apart), n);
            CHECK(std::abs(phong_lobe(at(40, -40 + apart), n) - exact) <= 1e-15 * (1 + 4 * n));
        }
        CHECK(phong_lobe(at(60, 60), n) == 0);  // V.R = -1/2: neither negative nor bright
        CHECK(phong_lobe(at(0, 180), n) == 0);
    }
}

TEST_CASE("03.2 the lobe does not care which is the light and which the viewer") {
    const auto only_lobe = [](const auto& g) { return Rgb<double>(phong_lobe(g, 7.0)); };
    for (const double light : {0.0, 20.0, 70.0, 89.9}) {
        for (const double view : {-80.0, -20.0, 10.0, 60.0}) {
            CHECK(reciprocity_error(only_lobe, at(light, view)) == Rgb<double>(0.0));
        }
    }
}

TEST_CASE_TEMPLATE("03.2 the lobe in every number type", T, float, ALL_LANES) {
    for (const double n : {0.0, 0.5, 1.0, 10.0, 1e3, 1e6}) {
        for (const double light : {0.0, 30.0, 60.0, 89.0}) {
            for (const double apart : {0.01, 1.0, 20.0, 60.0}) {
                const Incidence<double> g = at(light, -light + apart);
                const Incidence<float> f{float(g.NL), float(g.NV), float(g.LV)};
                const double exact = lobe<double>({f.NL, f.NV, f.LV}, n);
                CAPTURE(n);
                CAPTURE(light);
                CAPTURE(apart);
                const double cosine = cos_of_degrees(apart);
                const double bound = (4 + n * (4 + 2 * std::abs(std::log2(cosine)))) * 0x1p-23;
                CHECK(std::abs(lobe<T>({f.NL, f.NV, f.LV}, n) - exact) <= bound / cosine);
            }
        }
    }
}

TEST_CASE_TEMPLATE("03.2 the lobe at its ends", T, float, double, ALL_LANES) {
    for (const double n : {0.0, 0.5, 1.0, 2.0, 1e3, 1e6}) {
        CAPTURE(n);
        CHECK(lobe<T>({1, 1, 1}, n) == 1);          // L = V = N
        CHECK(lobe<T>({1, 1.0000002, 1}, n) == 1);  // V.R above 1 by rounding
        CHECK(lobe<T>({0, 0, -1}, n) == 1);         // grazing
        CHECK(lobe<T>({1e-8, 1e-8, -1}, n) == 1);
        CHECK(lobe<T>({0.5, 0.5, 0.5}, n) == 0);        // V.R = 0
        CHECK(lobe<T>({0.5, 0.5, 0.5000001}, n) == 0);  // just below
        CHECK(lobe<T>({0, 0, 0}, n) == 0);              // a normal and a direction of length 0
        CHECK(lobe<T>({double{nan}, 0.5, 0.5}, n) == 0);
        CHECK(lobe<T>({0.5, double{infinity}, 0.5}, n) == 1);
    }
    CHECK(lobe<T>({0.75, -0.5, -1}, 2) == 0.0625);  // the viewer below the horizon is not asked
}

TEST_CASE_TEMPLATE("03.3 L_o = BRDF E (N.L)", T, float, double, ALL_LANES) {
    const auto radiance = [](double NL) {
        const Rgb<T> Lo = reflect_light(Rgb<T>(T(0.25F), T(0.5F), T(8.0F)), Rgb<T>(T(2.0F)), T(NL));
        return glm::dvec3(value(Lo.r), value(Lo.g), value(Lo.b));
    };
    CHECK(radiance(1) == glm::dvec3(0.5, 1, 16));
    CHECK(radiance(0.5) == glm::dvec3(0.25, 0.5, 8));
    CHECK(radiance(1e-8).b == doctest::Approx(16e-8));
    for (const double none :
         {0.0, -1e-8, -0.5, -1.0, double{nan}, -static_cast<double>(infinity)}) {
        CHECK(radiance(none) == glm::dvec3(0));
    }
}

// By the definition: the light of a small disk in the sky, summed up, over the irradiance that it
// makes, is the BRDF towards its middle.
TEST_CASE("03.3 the ratio of radiance to irradiance tends to the BRDF") {
    const LambertPhong brdf{Rgb<float>(0.25F), Rgb<float>(0.5F), 20};
    const Quadrature rule = gauss_legendre(16);
    const double middle = 50 * pi / 180;
    double before = 1;
    for (const double size : {0.3, 0.03, 0.003}) {
        double E = 0;
        double Lo = 0;
        integrate(rule, middle - size, middle + size, [&](double theta) {
            return integrate(rule, -size, size, [&](double phi) {
                const auto g = incidence_of_angles(theta, 40 * pi / 180, pi + phi);
                const double weight = std::sin(theta);
                E += g.NL * weight;
                Lo += reflect_light(brdf(g), Rgb<double>(1.0), g.NL).g * weight;
                return 0.0;
            });
        });
        const double error = std::abs(Lo / E / brdf(at(50, -40)).g - 1);
        CHECK(error < 0.2 * before);
        before = error;
    }
    CHECK(before < 1e-4);
}

template <class T, class Shader>
Rgb<double> radiance(const Shader& shader, const glm::vec3& normal) {
    const Rgb<T> c =
        shader(typename Shader::template Varyings<T>{Vec3<T>(T(0.0F)), Vec3<T>(normal)});
    return {value(c.r), value(c.g), value(c.b)};
}

const glm::vec3 up(0, 0, 1);

// A light at so many degrees from a surface that the eye sees at 60 degrees from the other side.
template <class Shader>
Shader lit_at(double degrees, const auto& surface) {
    const glm::vec3 L(std::sin(degrees * pi / 180), 0, cos_of_degrees(degrees));
    const glm::vec3 eye(-10 * std::sin(pi / 3), 0, 10 * std::cos(pi / 3));
    return {surface, {.directional = {{L, Rgb<float>(2.0F)}}, .point = {}}, eye};
}

TEST_CASE("03 at the terminator lesson 1's highlight begins at once, the BRDF's at 0") {
    const Rgb<float> Cd(0.5F);
    const Rgb<float> Ks(0.25F);
    const Material material{.diffuse = Cd, .specular = Ks, .exponent = 4};
    const auto classic = [&](double degrees) {
        return radiance<double>(lit_at<AdHocPhong>(degrees, material), up).r;
    };
    const auto in_units = [&](double degrees) {
        return radiance<double>(lit_at<PhongInUnits>(degrees, LambertPhong{Cd, Ks, 4}), up).r;
    };
    const double jump = 0.25 * std::pow(std::sin(pi / 3), 4) * 2;
    CHECK(classic(90.001) == 0);
    CHECK(classic(89.999) == doctest::Approx(jump).epsilon(1e-3));
    CHECK(in_units(90.001) == 0);
    CHECK(in_units(89.999) < 1e-4);
    CHECK(in_units(60) ==
          doctest::Approx(0.75 * 2 * 0.5).epsilon(1e-6));  // in the mirror direction
}

TEST_CASE_TEMPLATE("03 the shader in every number type", T, float, ALL_LANES) {
    for (const float n : {0.0F, 0.5F, 1.0F, 50.0F, 1e3F, 1e6F}) {
        for (const double degrees : {0.0, 30.0, 59.0, 89.0, 89.999, 91.0}) {
            const auto shader = lit_at<PhongInUnits>(
                degrees, LambertPhong{Rgb<float>(0.5F, 0.3F, 0.1F), Rgb<float>(0.25F), n});
            const double bound = 3 * (1 + double{n}) * 0x1p-22;
            CHECK(length(radiance<T>(shader, up) - radiance<double>(shader, up)) <= bound);
        }
    }
}

TEST_CASE_TEMPLATE("03 normals of length zero show ambient light only", T, float, double,
                   ALL_LANES) {
    auto shader = lit_at<PhongInUnits>(10, LambertPhong{Rgb<float>(0.5F), Rgb<float>(0.5F), 0});
    shader.lighting.ambient = Rgb<float>(0.25F);
    for (const glm::vec3 normal : {glm::vec3(0), glm::vec3(nan), glm::vec3(infinity)}) {
        CHECK(radiance<T>(shader, normal) == Rgb<double>(0.125));
    }
}

}  // namespace
}  // namespace glint
