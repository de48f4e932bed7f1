#include "framework/app/window_compare.hpp"

#include "framework/image/heat_map.hpp"
#include "framework/math/error.hpp"

#include <doctest/doctest.h>

namespace glint {
namespace {

constexpr Rgba8 red{200, 10, 10, 255};
constexpr Rgba8 blue{10, 10, 200, 255};
constexpr Rgba8 white{255, 255, 255, 255};
constexpr Rgba8 black{0, 0, 0, 255};

TEST_CASE("left of the split line is the left picture, right of it the right one") {
    const SrgbImage both = split_picture(SrgbImage(20, 3, red), SrgbImage(20, 3, blue), 8);
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 20; ++x) {
            CAPTURE(x);
            CHECK(both(x, y) == (x < 7 ? red : x == 8 ? white : x == 7 || x == 9 ? black : blue));
        }
    }
}

TEST_CASE("the line may lie at the edge") {
    const SrgbImage a(4, 1, red);
    const SrgbImage b(4, 1, blue);
    CHECK(split_picture(a, b, 0)(0, 0) == white);
    CHECK(split_picture(a, b, 0)(2, 0) == blue);
    CHECK(split_picture(a, b, 3)(3, 0) == white);
    CHECK(split_picture(a, b, 3)(1, 0) == red);
    CHECK_THROWS_AS(split_picture(a, SrgbImage(4, 2), 1), Error);
}

TEST_CASE("the difference is that of the channel that differs most") {
    SrgbImage a(4, 2, Rgba8{100, 100, 100, 255});
    SrgbImage b = a;
    b(1, 0) = {101, 98, 100, 255};
    b(2, 1) = {100, 100, 164, 0};
    const CodeDifference d = code_difference(a, b);
    CHECK(d.largest == 64);
    CHECK(d.x == 2);
    CHECK(d.y == 1);
    CHECK(d.share == 0.25);
    CHECK(d.picture(0, 0) == heat_colour(0));
    CHECK(d.picture(1, 0) == heat_colour(difference_heat(2)));
    CHECK(d.picture(2, 1) == heat_colour(difference_heat(64)));
    CHECK(code_difference(b, a).picture == d.picture);
}

TEST_CASE("equal pictures have no difference") {
    const CodeDifference d = code_difference(SrgbImage(3, 3, red), SrgbImage(3, 3, red));
    CHECK(d.largest == 0);
    CHECK(d.share == 0);
    CHECK_THROWS_AS(code_difference(SrgbImage(3, 3), SrgbImage(3, 4)), Error);
}

TEST_CASE("one code shows, and 255 is the end of the scale") {
    CHECK(difference_heat(0) == 0);
    CHECK(difference_heat(1) > 0.05F);
    CHECK(difference_heat(64) == doctest::Approx(0.5).epsilon(0.01));
    CHECK(difference_heat(255) == 1);
}

}  // namespace
}  // namespace glint
