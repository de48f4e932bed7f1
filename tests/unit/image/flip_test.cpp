#include "framework/image/flip.hpp"

#include "framework/math/error.hpp"
#include "tests/unit/image/pictures.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

namespace glint {
namespace {

using doctest::Approx;

float flip_of_colours(const Rgba8& a, const Rgba8& b, int width = 1, int height = 1) {
    const Image<float> map = flip_map({width, height, a}, {width, height, b});
    const auto [low, high] = std::ranges::minmax(map.pixels());
    CHECK(high - low < 1e-5F);  // a constant difference is constant up to the edge
    return map(0, 0);
}

TEST_CASE("green against blue is the largest difference, 1") {
    CHECK(flip_of_colours({0, 255, 0, 255}, {0, 0, 255, 255}) == Approx(1.0).epsilon(1e-5));
    CHECK(flip_of_colours({0, 255, 0, 255}, {0, 0, 255, 255}, 40, 30) == Approx(1.0).epsilon(1e-5));
}

TEST_CASE("greys differ by their lightness alone") {
    // The distance from green to blue, from tables of CIELAB: |87.73 - 32.30| and the chroma, each
    // times L*/100.
    const double largest = std::pow(55.43 + std::hypot(75.60 + 25.58, 72.97 + 34.84), 0.7);
    const double knee = std::pow(100.0, 0.7) / largest;
    const double black_white = 0.95 + (knee - 0.4) / 0.6 * 0.05;
    CHECK(flip_of_colours({0, 0, 0, 255}, {255, 255, 255, 255}, 30, 5) ==
          Approx(black_white).epsilon(1e-4));
    const double l119 = 50.03;  // L* of code 119
    const double l128 = 53.59;
    CHECK(flip_of_colours({119, 119, 119, 255}, {128, 128, 128, 255}) ==
          Approx(std::pow(l128 - l119, 0.7) / largest * 0.95 / 0.4).epsilon(2e-3));
}

TEST_CASE("order does not matter, and equal pictures do not differ") {
    const SrgbImage a = patterned(50, 40, 3);
    const SrgbImage b = patterned(50, 40, 5);
    CHECK(flip_map(a, b) == flip_map(b, a));
    CHECK(flip_map(a, a) == Image<float>(50, 40, 0.0F));
}

TEST_CASE("a picture turned by 180 degrees gives the map turned") {
    SrgbImage a = metric_picture("sphere");
    SrgbImage b = metric_picture("sphere_shift");
    Image<float> map = flip_map(a, b);
    std::ranges::reverse(a.pixels());
    std::ranges::reverse(b.pixels());
    std::ranges::reverse(map.pixels());
    const Image<float> turned = flip_map(a, b);
    for (std::size_t i = 0; i < map.pixels().size(); ++i) {
        REQUIRE(map.pixels()[i] == Approx(turned.pixels()[i]).epsilon(1e-4));
    }
}

TEST_CASE("an edge that is missed counts more than its colour") {
    SrgbImage reference = grey_picture(60, 60, 120);
    SrgbImage edge = reference;
    for (int y = 0; y < 60; ++y) {
        for (int x = 30; x < 60; ++x) {
            edge(x, y) = {140, 140, 140, 255};
        }
    }
    const Image<float> map = flip_map(reference, edge);
    CHECK(map(30, 30) > 1.1F * map(55, 30));  // though its colour is blurred
    CHECK(map(5, 30) < 1e-5F);
}

TEST_CASE("who sits farther away sees less") {
    const SrgbImage a = metric_picture("sphere");
    const SrgbImage b = metric_picture("sphere_noise");
    const auto mean = [&](float pixels_per_degree) {
        const Image<float> map = flip_map(a, b, pixels_per_degree);
        double sum = 0.0;
        for (const float value : map.pixels()) {
            sum += value;
        }
        return sum / static_cast<double>(map.pixels().size());
    };
    CHECK(mean(20.0F) > mean(67.0F));
    CHECK(mean(67.0F) > mean(200.0F));
}

TEST_CASE("bad pairs") {
    CHECK_THROWS_AS(flip_map(grey_picture(3, 4, 0), grey_picture(4, 3, 0)), Error);
    CHECK_THROWS_AS(flip_map({}, {}), Error);
}

}  // namespace
}  // namespace glint
