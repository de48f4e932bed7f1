#include "framework/scene/false_colour.hpp"

#include "tests/unit/math/lane_types.hpp"

#include <doctest/doctest.h>

namespace glint {
namespace {

TEST_CASE("equal steps look equal, inside sRGB, ever lighter") {
    const auto lab = [](double x) { return cielab(xyz_from_rgb(Rgb<float>(false_colour(x)))); };
    double least = 1e9;
    double most = 0;
    for (int i = 0; i < 32; ++i) {
        const Rgb<double> c = false_colour(i / 32.0);
        CHECK(all(c.r >= 0 && c.g >= 0 && c.b >= 0));
        CHECK(all(c.r <= 1 && c.g <= 1 && c.b <= 1));
        const double step = double{length(lab((i + 1) / 32.0) - lab(i / 32.0))};
        least = std::min(least, step);
        most = std::max(most, step);
        CHECK(lab((i + 1) / 32.0).x > lab(i / 32.0).x);
    }
    CHECK(most < 2.5 * least);
}

TEST_CASE_TEMPLATE("what is beyond 0..1", T, float, double, ALL_LANES) {
    const auto equal = [](const Rgb<T>& a, const Rgb<T>& b) {
        return all((a.r == b.r) & (a.g == b.g) & (a.b == b.b));
    };
    const Rgb<T> warning(T(1.0F), T(0.0F), T(0.5F));
    CHECK(equal(false_colour(T(-1.0F)), false_colour(T(0.0F))));
    CHECK(equal(false_colour(T(-infinity)), false_colour(T(0.0F))));
    CHECK(equal(false_colour(T(1.0F + 1e-6F)), false_colour(T(1.0F))));
    CHECK(!equal(false_colour(T(1.0F)), warning));
    CHECK(equal(false_colour(T(1.001F)), warning));
    CHECK(equal(false_colour(T(infinity)), warning));
    CHECK(equal(false_colour(T(nan)), warning));
}

TEST_CASE_TEMPLATE("lanes agree with double", T, float, ALL_LANES) {
    for (float x = 0; x < 1; x += 0.03125F) {
        const Rgb<T> c = false_colour(T(x) + iota<T>() * T(0x1p-9F));
        for (int k = 0; k < lanes_of<T>; ++k) {
            const Rgb<double> d = false_colour(double{x} + k * 0x1p-9);
            CHECK(double{lane(c.r, k)} == doctest::Approx(d.r).epsilon(1e-4));
            CHECK(double{lane(c.g, k)} == doctest::Approx(d.g).epsilon(1e-4));
            CHECK(double{lane(c.b, k)} == doctest::Approx(d.b).epsilon(1e-4));
        }
    }
}

}  // namespace
}  // namespace glint
