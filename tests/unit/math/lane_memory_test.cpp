// What of lanes lies in memory otherwise than side by side.
#include "tests/unit/math/lane_types.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace glint {
namespace {

TEST_CASE_TEMPLATE("rows become columns and rows again", F, float, ALL_LANES) {
    std::array<float, 4 * 16> numbers{};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        numbers[i] = static_cast<float>(i);
    }
    std::array<const float*, lanes_of<F>> rows{};
    for (std::size_t i = 0; i < rows.size(); ++i) {
        rows[i] = &numbers[4 * (rows.size() - 1 - i)];
    }
    const Rows<F> columns = load_rows<F>(rows.data());
    std::array<float, 4 * lanes_of<F>> back{};
    store_rows(back.data(), columns);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        for (std::size_t k = 0; k < 4; ++k) {
            CHECK(lane(columns[k], static_cast<int>(i)) == rows[i][k]);
            CHECK(back[4 * i + k] == rows[i][k]);
        }
    }
}

TEST_CASE_TEMPLATE("load_fours skips what lies between", F, ALL_LANES) {
    using I = IntOf<F>;
    std::array<std::int32_t, 64> numbers{};
    std::iota(numbers.begin(), numbers.end(), 100);
    for (const std::ptrdiff_t stride : {0, 4, 7, 16}) {
        const I fours = load_fours<I>(&numbers[1], stride);
        for (int i = 0; i < lanes_of<F>; ++i) {
            CHECK(lane(fours, i) == 101 + i / 4 * stride + i % 4);
        }
    }
    CHECK(load_fours<std::int32_t>(&numbers[5], 3) == 105);
}

TEST_CASE_TEMPLATE("store_compressed keeps the answering lanes in order", F, float, ALL_LANES) {
    using I = IntOf<F>;
    constexpr int n = lanes_of<F>;
    const std::uint32_t step = n == 16 ? 7 : 1;
    for (std::uint32_t set = 0; set < 1U << n; set += step) {
        const I bit = select((iota<I>() >= I(0)), I(static_cast<std::int32_t>(set)), I(0));
        std::array<std::int32_t, 16> lane_bit{};
        for (int k = 0; k < n; ++k) {
            lane_bit[static_cast<std::size_t>(k)] = 1 << k;
        }
        const auto answers = (bit & load<I>(lane_bit.data())) != I(0);
        CHECK(lane_bits(answers) == set);
        std::array<std::int32_t, 17> to{};
        to.back() = 77;
        const int count = store_compressed(to.data(), answers, iota<I>() + I(100));
        std::size_t expected = 0;
        for (int k = 0; k < n; ++k) {
            if ((set >> k & 1U) != 0) {
                CHECK(to[expected] == 100 + k);
                ++expected;
            }
        }
        CHECK(static_cast<std::size_t>(count) == expected);
        CHECK(to[n] == (n == 16 ? 77 : 0));
        std::array<std::int32_t, 17> again{};
        CHECK(store_lanes(again.data(), set, iota<I>() + I(100)) == count);
        CHECK(std::equal(to.begin(), to.begin() + count, again.begin()));
    }
}

}  // namespace
}  // namespace glint
