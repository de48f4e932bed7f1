#include "framework/image/colour.hpp"

#include <doctest/doctest.h>

#include <initializer_list>

namespace glint {
namespace {

using doctest::Approx;

TEST_CASE("white is (1, 1, 1) and L* 100, black is 0") {
    const glm::vec3 white = xyz_from_rgb(Rgb<float>(1.0F));
    CHECK(distance(white, glm::vec3(1.0F)) < 1e-6F);
    CHECK(distance(cielab(white), glm::vec3(100, 0, 0)) < 1e-3F);
    CHECK(distance(cielab(xyz_from_rgb(Rgb<float>(0.0F))), glm::vec3(0)) < 1e-5F);
}

TEST_CASE("the primaries lie where tables of CIELAB have them") {
    CHECK(distance(cielab(xyz_from_rgb({1, 0, 0})), glm::vec3(53.24, 80.09, 67.20)) < 0.05F);
    CHECK(distance(cielab(xyz_from_rgb({0, 1, 0})), glm::vec3(87.73, -86.18, 83.18)) < 0.05F);
    CHECK(distance(cielab(xyz_from_rgb({0, 0, 1})), glm::vec3(32.30, 79.19, -107.86)) < 0.05F);
    CHECK(cielab(glm::vec3(0.18F)).x == Approx(49.4961).epsilon(1e-5));
    CHECK(cielab(glm::vec3(0.001F)).x == Approx(0.9033).epsilon(1e-4));  // the straight part
}

TEST_CASE("there and back") {
    for (const Rgb<float>& rgb : {Rgb<float>(0.2F, 0.5F, 0.9F), Rgb<float>(1.0F, 0.0F, 0.3F)}) {
        const glm::vec3 xyz = xyz_from_rgb(rgb);
        CHECK(distance(rgb_from_xyz(xyz), rgb) < 1e-5F);
        CHECK(distance(from_opponent(opponent(xyz)), xyz) < 1e-5F);
    }
}

}  // namespace
}  // namespace glint
