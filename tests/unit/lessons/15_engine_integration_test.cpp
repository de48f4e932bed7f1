#include "lessons/15_engine_integration/engine_phong.hpp"
#include "lessons/15_engine_integration/lit_from_afar.hpp"
#include "lessons/15_engine_integration/shelves.hpp"
#include "lessons/15_engine_integration/where_it_shows.hpp"
#include "framework/measure/gonioreflectometer.hpp"
#include "framework/image/srgb.hpp"
#include "tests/unit/lessons/lane_value.hpp"

#include <doctest/doctest.h>

namespace glint {
namespace {

const Rgb<float> Cd(0.6F, 0.3F, 0.1F);
const Rgb<float> F0(0.04F, 0.05F, 0.06F);

Lighting two_lights() {
    Lighting l;
    l.directional = {{normalize(glm::vec3(1, 2, 3)), {3, 2, 1}}};
    l.point = {{{-1, 2, 2}, {4, 5, 6}}};
    l.ambient = {0.1F, 0.2F, 0.3F};
    return l;
}

template <class Brdf, Real T>
Rgb<T> shade(const Brdf& brdf, const Lighting& lighting, const glm::vec3& normal,
             const glm::vec3& eye = {0.3F, 0.1F, 2}) {
    using Varyings = typename Lit<Brdf>::template Varyings<T>;
    return Lit<Brdf>{brdf, lighting, eye}(Varyings{Vec3<T>(T(0.0F)), Vec3<T>(normal)});
}

TEST_CASE("15.1 the slides' formula, term by term") {
    for (const double theta : {0.1, 0.9, 1.4}) {
        for (const double n : {0.5, 1.0, 32.0, 1e3}) {
            const Incidence<double> g = incidence_of_angles(theta, 0.8, 3.0);
            const double VR = 2 * g.NL * g.NV - g.LV;
            const auto f = EnginePhong{Cd, F0, static_cast<float>(n)}(g);
            for (int band = 0; band < 3; ++band) {
                const double R0 = double{F0[band]};
                const double R = R0 + (1 - R0) * std::pow(1 - g.NL, 5);
                const double expected = double{Cd[band]} * (1 - R0) / pi +
                                        (n + 2) / (2 * pi) * R * std::pow(std::max(VR, 0.0), n);
                CHECK(f[band] == doctest::Approx(expected).epsilon(1e-12));
            }
        }
    }
}

TEST_CASE_TEMPLATE("from afar as near", T, float, double, ALL_LANES) {
    const EnginePhong phong{Cd, F0, 40};
    Lighting lighting = two_lights();
    lighting.point.clear();
    const Lit<EnginePhong> lit{phong, lighting, {0.3F, 0.1F, 2}};
    for (const glm::vec3 normal : {glm::vec3(0, 0, 1), glm::vec3(0.6F, 0, 0.8F), glm::vec3(0)}) {
        const Vec3<T> position(glm::vec3(-0.2F, 0.3F, 0.4F));
        const Rgb<T> near =
            lit(typename Lit<EnginePhong>::template Varyings<T>{position, Vec3<T>(normal)});
        const LitFromAfar from_afar{{phong, -2.0F}, lighting};
        const Vec3<T> to_eye = T(0.1F) * (Vec3<T>(lit.eye) - position);
        const Rgb<T> far = from_afar(LitFromAfar::Varyings<T>{Vec3<T>(normal), to_eye});
        for (int band = 0; band < 3; ++band) {
            CHECK(value(far[band]) == doctest::Approx(value(near[band])).epsilon(1e-5));
        }
    }
}

TEST_CASE("15.2 constant light meets what is left for the diffuse part; a metal shows none") {
    Lighting constant;
    constant.ambient = Rgb<float>(2.0F);
    const auto radiance = shade<EnginePhong, double>({Cd, F0, 10}, constant, {0, 0, 1});
    CHECK(radiance.r == doctest::Approx(2 * 0.6 * 0.96).epsilon(1e-6));
    CHECK(radiance.b == doctest::Approx(2 * 0.1 * 0.94).epsilon(1e-6));
    const EnginePhong gold{diffuse_albedo(Cd, true), specular_colours[7].F0, 10};
    CHECK(shade<EnginePhong, double>(gold, constant, {0, 0, 1}) == Rgb<double>(0));
}

TEST_CASE_TEMPLATE("15.3 with and without pi: the same picture", T, float, double, ALL_LANES) {
    for (const glm::vec3 normal : {glm::vec3(0, 0, 1), glm::vec3(0.6F, 0, 0.8F)}) {
        for (const float n : {0.0F, 1.0F, 50.0F, 1e3F}) {
            const EnginePhong brdf{Cd, F0, n};
            const auto with = shade<EnginePhong, T>(brdf, two_lights(), normal);
            const auto without =
                shade<EnginePhongWithoutPi, T>({brdf}, lights_without_pi(two_lights()), normal);
            for (int band = 0; band < 3; ++band) {
                CHECK(value(without[band]) == doctest::Approx(value(with[band])).epsilon(1e-6));
            }
        }
    }
}

TEST_CASE("15.3 the peaks of n = 32 with and without pi") {
    const EnginePhong mirror{Rgb<float>(0.0F), Rgb<float>(1.0F), 32};
    const Incidence<double> along{1, 1, 1};
    CHECK(std::abs(mirror(along).g - 5.411) < 5e-4);
    CHECK(std::abs(EnginePhongWithoutPi{mirror}(along).g - 17) < 1e-9);
}

TEST_CASE("light adds up") {
    const EnginePhong brdf{Cd, F0, 20};
    Lighting first = two_lights();
    Lighting second = two_lights();
    first.point.clear();
    second.directional.clear();
    second.ambient = Rgb<float>(0.0F);
    const glm::vec3 normal(0, 0, 1);
    const auto sum = shade<EnginePhong, double>(brdf, first, normal) +
                     shade<EnginePhong, double>(brdf, second, normal);
    const auto both = shade<EnginePhong, double>(brdf, two_lights(), normal);
    for (int band = 0; band < 3; ++band) {
        CHECK(both[band] == doctest::Approx(sum[band]).epsilon(1e-14));
    }
}

TEST_CASE_TEMPLATE("15 in every number type", T, float, ALL_LANES) {
    for (const glm::vec3 normal : {glm::vec3(0, 0, 1), glm::vec3(0.6F, 0, 0.8F),
                                   glm::vec3(0.9F, 0.3F, 0.1F), glm::vec3(-1, 0, 0)}) {
        for (const float n : {0.0F, 0.5F, 1.0F, 50.0F, 1e3F}) {
            const EnginePhong brdf{Cd, F0, n};
            const auto exact = shade<EnginePhong, double>(brdf, two_lights(), normal);
            const auto got = shade<EnginePhong, T>(brdf, two_lights(), normal);
            for (int band = 0; band < 3; ++band) {
                const double bound = (1e-6 + 2.5e-7 * double{n}) * (1 + exact[band]);
                CHECK(std::abs(value(got[band]) - exact[band]) < bound);
            }
        }
    }
}

TEST_CASE_TEMPLATE("15 leaves out only highlights that do not show", T, float, ALL_LANES) {
    Lighting lights;
    for (int i = 0; i < 5; ++i) {
        lights.directional.push_back({normalize(glm::vec3(i - 2, 1, 3)), {2, 1, 0.5F}});
    }
    const float least = radiance_of_codes(0.25F);
    CHECK(srgb_encode(double{least}) * 255 == doctest::Approx(0.25));
    int left_out = 0;
    for (const float n : {0.5F, 3.0F, 50.0F, 1e4F}) {
        const EnginePhong phong{Cd, F0, n};
        const WhereItShows some{phong, highlight_from(phong, lights, least)};
        for (float tilt = -1.5F; tilt < 1.5F; tilt += 0.05F) {
            const glm::vec3 normal(std::sin(tilt), 0.1F, std::cos(tilt));
            const auto all = shade<EnginePhong, T>(phong, lights, normal);
            const auto fewer = shade<WhereItShows, T>(some, lights, normal);
            for (int band = 0; band < 3; ++band) {
                const double lost = value(all[band]) - value(fewer[band]);
                CHECK(lost >= -1e-6);
                CHECK(lost <= double{least} + 1e-6);
                left_out += lost != 0 ? 1 : 0;
            }
        }
    }
    CHECK(left_out > 20);
}

TEST_CASE("15 where highlights are computed") {
    Lighting lights;
    const EnginePhong phong{Cd, F0, 50};
    CHECK(highlight_from(phong, lights, 1e-3F) > 1);  // no light, no highlight
    lights.directional = {{{0, 0, 1}, {2, 1, 1}}};
    const float from = highlight_from(phong, lights, 1e-3F);
    CHECK(52 / (2 * pi) * std::pow(double{from}, 50) * 2 == doctest::Approx(1e-3));
    CHECK(highlight_from(phong, lights, 1e3F) > 1);  // as weak as that everywhere
    CHECK(highlight_from(phong, lights, 0) < -1);
    CHECK(highlight_from({Cd, F0, 0}, lights, 1e-3F) < -1);
    lights.point = {{{0, 0, 1}, {1, 1, 1}}};
    CHECK(highlight_from(phong, lights, 1e-3F) < -1);
    const auto in_double = shade<WhereItShows, double>({phong, -2}, two_lights(), {0, 0, 1});
    CHECK(in_double == shade<EnginePhong, double>(phong, two_lights(), {0, 0, 1}));
}

TEST_CASE_TEMPLATE("15 at its ends", T, float, double, ALL_LANES) {
    const EnginePhong brdf{Cd, F0, 20};
    const auto ambient = two_lights().ambient * brdf.ambient_albedo();
    const auto only_ambient = [&](const glm::vec3& normal) {
        const auto radiance = shade<EnginePhong, T>(brdf, two_lights(), normal);
        for (int band = 0; band < 3; ++band) {
            CHECK(value(radiance[band]) == doctest::Approx(double{ambient[band]}).epsilon(1e-6));
        }
    };
    only_ambient({0, 0, 0});       // an interpolated normal of length zero
    only_ambient({0, -0.5F, -1});  // looks away from every light
    only_ambient({nan, 0, 1});
    only_ambient({infinity, 0, 1});
    const glm::vec3 away(0.9F, 0.3F, -0.3F);  // lit, but looks away from the viewer: as it is
    const auto seen = shade<EnginePhong, T>(brdf, two_lights(), away);
    CHECK(value(seen.r) > double{ambient.r});
    CHECK(std::isfinite(value(seen.r)));
}

// Lesson 1's highlight as a BRDF: its lights are E/pi, and it leaves N.L out.
struct TweakedHighlight {
    Rgb<float> Ks;
    float n;
    template <Real T>
    Rgb<T> operator()(const Incidence<T>& g) const {
        return Ks * (phong_lobe(g, T(n)) * inverse_pi<T> / g.NL);
    }
};

TEST_CASE("the share of light in the highlights, tweaked and physical: the README's table") {
    const double expected[][4] = {// lesson 1 at 0 and 80 degrees, lesson 15 at 0 and 80 degrees
                                  {.0025, .0027, .0400, .0777},
                                  {.0135, .0140, .0400, .0741},
                                  {.0082, .0082, .0400, .0716},
                                  {.0209, .0217, .7100, .1483}};
    const auto before = shelves::tweaked();
    const auto after = shelves::physical();
    for (std::size_t i = 0; i < 4; ++i) {
        CAPTURE(before[i].name);
        const TweakedHighlight tweaked{before[i].specular, before[i].exponent};
        const EnginePhong engine{Rgb<float>(0.0F), after[i].specular, after[i].exponent};
        const double low = cos_of_degrees(80);
        CHECK(std::abs(directional_albedo(tweaked, 1).g - expected[i][0]) < 6e-5);
        CHECK(std::abs(directional_albedo(tweaked, low).g - expected[i][1]) < 6e-5);
        CHECK(std::abs(directional_albedo(engine, 1).g - expected[i][2]) < 6e-5);
        CHECK(std::abs(directional_albedo(engine, low).g - expected[i][3]) < 6e-5);
    }
}

TEST_CASE("light from everywhere as a sum makes the irradiance pi L on every surface") {
    Lighting l;
    shelves::surround(l, [](const glm::vec3&) { return Rgb<float>(2.0F); });
    const glm::vec3 normals[] = {{0, 1, 0}, {1, 0, 0}, {0, -1, 0}, {0.6F, 0, -0.8F}};
    for (const glm::vec3& normal : normals) {
        double irradiance = 0;
        for (const DirectionalLight& light : l.directional) {
            irradiance +=
                double{light.irradiance.g} * std::max(double{dot(normal, light.direction)}, 0.0);
        }
        CHECK(irradiance == doctest::Approx(2 * pi).epsilon(0.01));
    }
}

}  // namespace
}  // namespace glint
