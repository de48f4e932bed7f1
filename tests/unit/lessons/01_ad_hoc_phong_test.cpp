#include "lessons/01_ad_hoc_phong/ad_hoc_phong.hpp"
#include "framework/scene/stages.hpp"
#include "tests/unit/lessons/lane_value.hpp"

#include <doctest/doctest.h>

namespace glint {
namespace {

const glm::dvec3 z(0, 0, 1);

// At so many degrees from z, in the xz plane.
glm::dvec3 tilted(double degrees) {
    return {std::sin(degrees * pi / 180), 0, cos_of_degrees(degrees)};
}

AdHocPhong shiny(std::vector<DirectionalLight> lights, float n = 10) {
    return {{.diffuse = Rgb<float>(0.5F), .specular = Rgb<float>(0.25F), .exponent = n},
            {.directional = std::move(lights), .point = {}, .ambient = Rgb<float>(0.125F)},
            {0, 0, 10}};
}

// The colour of a surface at the origin that faces z, seen from z.
template <class T>
Rgb<double> colour(const AdHocPhong& shader, const glm::vec3& normal = {0, 0, 1}) {
    const Rgb<T> c = shader(AdHocPhong::Varyings<T>{Vec3<T>(T(0.0F)), Vec3<T>(normal)});
    return {value(c.r), value(c.g), value(c.b)};
}

TEST_CASE("01.1 N.L, and nothing from below the horizon") {
    for (const double degrees : {0.0, 30.0, 60.0, 89.999, 90.0}) {
        CHECK(matt_shading(z, tilted(degrees)) == doctest::Approx(cos_of_degrees(degrees)));
        CHECK(matt_shading(z, tilted(180 - degrees)) == doctest::Approx(0));
    }
}

TEST_CASE("01.2 the mirror direction is as far from the normal, on its other side") {
    for (const double degrees : {0.0, 20.0, 45.0, 89.0, 90.0, 120.0}) {
        CHECK(length(mirrored(z, tilted(degrees)) - tilted(-degrees)) < 1e-15);
        const glm::dvec3 L = normalize(tilted(degrees) + glm::dvec3(0, 0.3, 0));
        const glm::dvec3 R = mirrored(tilted(30), L);
        CHECK(length(R) == doctest::Approx(1).epsilon(1e-15));
        CHECK(length(mirrored(tilted(30), R) - L) < 1e-15);
    }
}

TEST_CASE("01.3 the highlight is the n-th power of the cosine between V and R") {
    for (const double n : {0.5, 1.0, 2.0, 10.0, 1e3, 1e6}) {
        for (const double apart : {0.0, 0.05, 1.0, 20.0, 60.0, 89.0}) {
            const double exact = std::pow(cos_of_degrees(apart), n);
            const double x = highlight(z, tilted(30), tilted(-30 + apart), n);
            CHECK(std::abs(x - exact) <= 1e-15 * (1 + 4 * n));
        }
    }
    CHECK(highlight(z, tilted(60), tilted(60), 3.0) == 0);     // V.R < 0, an odd power
    CHECK(highlight(z, tilted(60), tilted(60), 2.0) == 0);     // and an even one
    CHECK(highlight(z, tilted(60), tilted(60), 2.5) == 0);     // one that has no real value
    CHECK(highlight(z, tilted(60), tilted(60), 0.0) == 0);     // n = 0: half the directions
    CHECK(highlight(z, tilted(30), tilted(30), 0.0) == 1);     // L = V, 60 degrees from R
    CHECK(highlight(z, tilted(100), tilted(-100), 5.0) == 0);  // light from below
    CHECK(highlight(z, tilted(85), tilted(-95), 5.0) > 0.9);   // the viewer is not asked
}

TEST_CASE_TEMPLATE("01 in every number type", T, float, ALL_LANES) {
    for (const float n : {0.0F, 0.5F, 1.0F, 50.0F, 1e3F, 1e6F}) {
        for (const double of_light : {0.0, 1.0, 45.0, 80.0, 89.9, 100.0}) {
            const glm::vec3 L = tilted(of_light);
            const AdHocPhong shader = shiny({{L, Rgb<float>(1.0F, 2.0F, 3.0F)}}, n);
            const Rgb<double> f = colour<T>(shader);
            const Rgb<double> d = colour<double>(shader);
            CAPTURE(n);
            CAPTURE(of_light);
            const double bound = 3 * (1 + double{n}) * 0x1p-22;  // (V.R)^n magnifies by n
            CHECK(length(f - d) <= bound);
        }
    }
}

TEST_CASE_TEMPLATE("01 at the ends", T, float, double, ALL_LANES) {
    const glm::vec3 up(0, 0, 1);
    const glm::vec3 below(0, 0, -1);
    const Rgb<double> ambient(0.0625);
    CHECK(colour<T>(shiny({})) == ambient);
    CHECK(colour<T>(shiny({{below, Rgb<float>(1.0F)}}, 0)) == ambient);
    CHECK(colour<T>(shiny({{{1, 0, 0}, Rgb<float>(1.0F)}}, 0)) == ambient);  // N.L = 0
    CHECK(colour<T>(shiny({{up, Rgb<float>(1.0F)}})) == ambient + 0.75);
    CHECK(colour<T>(shiny({{up, Rgb<float>(1.0F)}}, 1e6F)) == ambient + 0.75);
    CHECK(colour<T>(shiny({{up, Rgb<float>(1.0F)}, {up, Rgb<float>(2.0F)}})) == ambient + 2.25);
    for (const glm::vec3 normal : {glm::vec3(0), glm::vec3(nan), glm::vec3(infinity)}) {
        CHECK(colour<T>(shiny({{up, Rgb<float>(1.0F)}}), normal) == ambient);
    }
    AdHocPhong inside = shiny({{up, Rgb<float>(1.0F)}}, 0);
    inside.eye = glm::vec3(0);  // in the surface itself: no direction to look from, no highlight
    CHECK(colour<T>(inside) == ambient + 0.5);
}

// The numbers of the text: a surface that faces the key light, seen from there.
TEST_CASE("01 under other lights the same constants add up to more than a picture holds") {
    const Material porcelain = stages::still_life_upright().materials[2];
    const auto red_facing_key = [&](const Lighting& lighting) {
        const glm::vec3 L = lighting.directional[0].direction;
        return colour<double>({porcelain, lighting, 10.0F * L}, L).r;
    };
    CHECK(std::abs(red_facing_key(stages::key_and_fill()) - 1.13) < 0.005);
    CHECK(std::abs(red_facing_key(stages::three_lamps()) - 1.72) < 0.005);
}

}  // namespace
}  // namespace glint
