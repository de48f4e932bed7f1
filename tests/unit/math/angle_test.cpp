#include "framework/math/angle.hpp"

#include "tests/unit/math/lane_types.hpp"
#include "tests/worst.hpp"

#include <doctest/doctest.h>

namespace glint {
namespace {

TEST_CASE_TEMPLATE("acute_angle is within 5e-7 of the angle", F, float, ALL_LANES) {
    double worst = 0;
    int differing = 0;
    const auto check = [&](double angle) {
        const auto cosine = static_cast<float>(std::cos(angle));
        const auto sin2 = static_cast<float>(std::sin(angle) * std::sin(angle));
        const F found = acute_angle(F(cosine), F(sin2));
        worst = worse(worst, std::abs(double{lane(found, lanes_of<F> - 1)} / angle - 1));
        differing += same(lane(found, 0), acute_angle(cosine, sin2)) ? 0 : 1;
    };
    const double right = std::numbers::pi / 2;
    for (int i = 1; i <= 100000; ++i) {
        check(right * i / 100000);
        check(right * std::exp2(-i / 2000.0));
    }
    CHECK(differing == 0);
    CHECK(worst < 5e-7);
}

TEST_CASE_TEMPLATE("acute_angle at and beyond its ends", T, float, double, ALL_LANES) {
    const auto at = [](float cosine, float sin2) {
        if constexpr (std::same_as<T, double>) {
            return acute_angle(double{cosine}, double{sin2});
        } else {
            return double{lane(acute_angle(T(cosine), T(sin2)), 0)};
        }
    };
    const double right = std::numbers::pi / 2;
    CHECK(at(1, 0) == 0);
    CHECK(std::abs(at(0, 1) - right) < 1e-7);
    CHECK(at(0, 0) == 0);
    CHECK(at(1.0000001F, -1e-9F) == 0);
    CHECK(at(infinity, -infinity) == 0);
    CHECK(std::abs(at(-2, 2) - right) < 1e-7);
    CHECK(std::abs(at(-infinity, infinity) - right) < 1e-7);
    CHECK(std::abs(at(nan, 1) - right) < 1e-7);
    CHECK(at(1, nan) == 0);
    CHECK(at(nan, nan) == 0);
}

}  // namespace
}  // namespace glint
