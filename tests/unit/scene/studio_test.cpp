#include "framework/scene/studio.hpp"

#include "tests/unit/math/lane_types.hpp"

#include <doctest/doctest.h>

namespace glint {
namespace {

TEST_CASE("the studio's lamps are rectangles") {
    for (const SoftBox& lamp : studio_lamps) {
        for (const glm::vec3& axis : {lamp.towards, lamp.right, lamp.up}) {
            CHECK(std::abs(length(axis) - 1) < 1e-6F);
        }
        CHECK(std::abs(dot(lamp.towards, lamp.right)) < 1e-6F);
        CHECK(std::abs(dot(lamp.towards, lamp.up)) < 1e-6F);
        CHECK(std::abs(dot(lamp.right, lamp.up)) < 1e-6F);
    }
}

TEST_CASE("a soft box is bright in its middle, half as bright inside its edge and dark outside") {
    const SoftBox box{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0.5F, 0.25F}, 3.0F};
    CHECK(radiance_of(box, glm::vec3(0, 0, 1)) == 3.0F);
    CHECK(radiance_of(box, glm::vec3(0, 0, -1)) == 0.0F);
    const auto at = [&](float x, float y) { return radiance_of(box, glm::vec3(x, y, 1)); };
    CHECK(at(0.40F, 0.15F) == doctest::Approx(3.0F));
    CHECK(at(0.455F, 0) == doctest::Approx(1.5F));
    CHECK(at(0, -0.205F) == doctest::Approx(1.5F));
    CHECK(at(0.51F, 0) == 0.0F);
    CHECK(at(0, 0.26F) == 0.0F);
}

TEST_CASE("the studio lights every direction, in grey, most from the lamps") {
    for (int i = 0; i < 4000; ++i) {
        const float z = 1 - static_cast<float>(i) / 2000;
        const float turn = 2.399963F * static_cast<float>(i);  // the golden angle
        const float r = std::sqrt(std::max(1 - z * z, 0.0F));
        const Rgb<float> light = Studio{}(glm::vec3(r * std::cos(turn), r * std::sin(turn), z));
        REQUIRE(light.r > 0);
        REQUIRE(light.r < 8);
        REQUIRE(light.r == light.g);
        REQUIRE(light.r == light.b);
    }
    for (const SoftBox& lamp : studio_lamps) {
        CHECK(Studio{}(lamp.towards).g >= lamp.radiance);
    }
    CHECK(Studio{}(normalize(glm::vec3(0, 0.12F, -1))).g == doctest::Approx(0.636).epsilon(0.01));
    CHECK(Studio{}(glm::vec3(0, -1, 0)).g == doctest::Approx(0.15));
    CHECK(Studio{.room = 0, .pool = 0, .lamps = 2}(glm::vec3(0, 0, -1)).g == 0);
    CHECK(Studio{.room = 2, .pool = 1, .lamps = 0}(studio_lamps[0].towards).g < 1);
}

TEST_CASE_TEMPLATE("the studio is the same on many lanes", T, double, ALL_LANES) {
    for (int i = 0; i < 100; ++i) {
        const float turn = 0.0628F * static_cast<float>(i);
        const glm::vec3 d =
            normalize(glm::vec3(std::sin(turn), std::cos(3 * turn), std::cos(turn)));
        const T light = Studio{}(Vec3<T>(d)).g;
        const auto error = abs(light - T(Studio{}(d).g));
        CHECK(all(error < T(1e-5F)));
    }
}

}  // namespace
}  // namespace glint
