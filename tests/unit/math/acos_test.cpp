#include "framework/math/acos.hpp"

#include "tests/unit/math/lane_types.hpp"

#include <doctest/doctest.h>

namespace glint {
namespace {

TEST_CASE_TEMPLATE("acos is within 5e-7 of the angle", F, float, Float4, Float8, Float16) {
    double worst = 0;
    int differing = 0;
    for (int i = -100000; i <= 100000; ++i) {
        const float x = static_cast<float>(i) / 100000;
        const F angle = acos(F(x));
        worst =
            std::max(worst, std::abs(double{lane(angle, lanes_of<F> - 1)} - std::acos(double{x})));
        differing += same(lane(angle, 0), acos(x)) ? 0 : 1;
    }
    CHECK(differing == 0);
    CHECK(worst < 5e-7);
}

TEST_CASE("acos near 1, where it is steep") {
    for (const float below : {0x1p-24F, 1e-6F, 1e-4F, 1e-2F}) {
        const float x = 1 - below;
        CHECK(std::abs(double{acos(x)} / std::acos(double{x}) - 1) < 3e-7);
    }
    CHECK(acos(1.0F) == 0);
    CHECK(acos(1.0) == 0);
}

TEST_CASE_TEMPLATE("acos beyond its range", T, float, double, Float4, Float8, Float16) {
    const auto at = [](float x) {
        if constexpr (std::same_as<T, double>) {
            return acos(double{x});
        } else {
            return double{lane(acos(T(x)), 0)};
        }
    };
    const double pi = std::numbers::pi;
    CHECK(std::abs(at(0) - pi / 2) < 1e-7);
    CHECK(std::abs(at(-1) - pi) < 1e-6);
    CHECK(at(1.0000001F) == 0);
    CHECK(at(infinity) == 0);
    CHECK(std::abs(at(-2) - pi) < 1e-6);
    CHECK(std::abs(at(-infinity) - pi) < 1e-6);
    CHECK(std::abs(at(nan) - pi) < 1e-6);
}

}  // namespace
}  // namespace glint
