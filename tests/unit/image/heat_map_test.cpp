#include "framework/image/heat_map.hpp"

#include "framework/image/colour.hpp"
#include "framework/image/srgb.hpp"
#include "framework/math/error.hpp"
#include "tests/unit/image/pictures.hpp"

#include <doctest/doctest.h>

#include <limits>

namespace glint {
namespace {

// CIELAB is not the space that the colours were chosen in.
glm::vec3 lab_of(int step) {
    const Rgba8 c = heat_colour(static_cast<float>(step) / 255.0F);
    return cielab(xyz_from_rgb({srgb_to_linear(c.r), srgb_to_linear(c.g), srgb_to_linear(c.b)}));
}

TEST_CASE("more error is lighter, from almost black to almost white") {
    CHECK(lab_of(0).x < 2.0F);
    CHECK(lab_of(255).x > 92.0F);
    for (int step = 1; step < 256; ++step) {
        CAPTURE(step);
        CHECK(lab_of(step).x >= lab_of(step - 1).x);
    }
    for (int step = 16; step < 256; step += 16) {
        const float rise = lab_of(step).x - lab_of(step - 16).x;
        CAPTURE(step);
        CHECK(rise > 1.0F);
        CHECK(rise < 10.0F);
    }
}

TEST_CASE("each colour is one of its own") {
    for (int step = 2; step < 256; ++step) {
        CHECK(heat_colour(static_cast<float>(step) / 255.0F) !=
              heat_colour(static_cast<float>(step - 2) / 255.0F));
    }
}

TEST_CASE("what is out of range is shown as the end, NaN as the worst") {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    CHECK(heat_colour(-1.0F) == heat_colour(0.0F));
    CHECK(heat_colour(-infinity) == heat_colour(0.0F));
    CHECK(heat_colour(2.0F) == heat_colour(1.0F));
    CHECK(heat_colour(infinity) == heat_colour(1.0F));
    CHECK(heat_colour(std::numeric_limits<float>::quiet_NaN()) == heat_colour(1.0F));
}

TEST_CASE("a map has the colour of each error at its place") {
    Image<float> error(3, 2);
    error(0, 0) = 0.25F;
    error(2, 1) = 0.75F;
    const SrgbImage map = heat_map(error);
    CHECK(map(0, 0) == heat_colour(0.25F));
    CHECK(map(2, 1) == heat_colour(0.75F));
    CHECK(map(1, 1) == heat_colour(0.0F));
}

TEST_CASE("side by side: reference, test, heat, two white columns between") {
    const SrgbImage all = side_by_side(patterned(5, 4, 3), patterned(5, 4, 7), patterned(5, 4, 9));
    CHECK(all.width() == 19);
    CHECK(all.height() == 4);
    const Rgba8 white{255, 255, 255, 255};
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 5; ++x) {
            CHECK(all(x, y) == patterned(5, 4, 3)(x, y));
            CHECK(all(x + 7, y) == patterned(5, 4, 7)(x, y));
            CHECK(all(x + 14, y) == patterned(5, 4, 9)(x, y));
        }
        CHECK(all(5, y) == white);
        CHECK(all(6, y) == white);
        CHECK(all(13, y) == white);
    }
    CHECK_THROWS_AS(side_by_side(patterned(5, 4, 3), patterned(5, 4, 3), patterned(4, 5, 3)),
                    Error);
}

}  // namespace
}  // namespace glint
