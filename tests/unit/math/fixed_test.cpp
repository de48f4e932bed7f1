#include "framework/math/fixed.hpp"

#include "tests/unit/math/lane_types.hpp"

#include <doctest/doctest.h>

#include <random>

namespace glint {
namespace {

TEST_CASE_TEMPLATE("snap rounds to the nearest 1/256 pixel, ties to even", F, float, ALL_LANES) {
    const auto snapped = [](float x) { return lane(snap(F(x)), lanes_of<F> - 1); };
    CHECK(snapped(0.0F) == 0);
    CHECK(snapped(1.0F) == 256);
    CHECK(snapped(-0.75F) == -192);
    CHECK(snapped(0.5F / 256.0F) == 0);
    CHECK(snapped(1.5F / 256.0F) == 2);
    CHECK(snapped(-2.5F / 256.0F) == -2);
    CHECK(snapped(2.5000002F / 256.0F) == 3);
    CHECK(snapped(guard_band) == 1 << 22);
    CHECK(snapped(-guard_band) == -(1 << 22));

    std::mt19937 random(4);
    std::uniform_real_distribution<float> anywhere(-guard_band, guard_band);
    for (int i = 0; i < 10000; ++i) {
        const float x = anywhere(random);
        const double exact = static_cast<double>(x) * 256.0;
        CHECK(snapped(x) == static_cast<std::int32_t>(std::nearbyint(exact)));
    }
}

}  // namespace
}  // namespace glint
