#include "tests/unit/math/lane_types.hpp"
#include "tests/worst.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <limits>

namespace glint {
namespace {

constexpr float smallest = std::numeric_limits<float>::denorm_min();
constexpr float largest = std::numeric_limits<float>::max();
constexpr std::int32_t least = std::numeric_limits<std::int32_t>::min();
constexpr std::int32_t most = std::numeric_limits<std::int32_t>::max();

// Followed by its own beginning, so that every lane of every width meets every value.
template <class T, std::size_t N>
constexpr auto repeated(const std::array<T, N>& values) {
    std::array<T, N + 16> all{};
    for (std::size_t i = 0; i < all.size(); ++i) {
        all[i] = values[i % N];
    }
    return all;
}
constexpr auto floats =
    repeated(std::array{0.0F, -0.0F, 1.0F, -1.0F, 0.5F, -2.5F, 1e-30F, 1e30F, smallest, -largest,
                        16777217.0F, nan, infinity, -infinity, 3.7F, -1234.75F, 0.1F});
constexpr auto ints = repeated(
    std::array<std::int32_t, 11>{0, 1, -1, 2, -7, 255, 65536, -65537, most, least, 123456789});

// op of lanes does to every lane what expected does to a scalar.
template <class V, class Values, class Op, class Expected>
void check_each(const Values& values, Op op, Expected expected) {
    for (std::size_t i = 0; i + 16 < values.size(); ++i) {
        const auto r = op(load<V>(&values[i]));
        for (int k = 0; k < lanes_of<V>; ++k) {
            const auto a = values[i + static_cast<std::size_t>(k)];
            CHECK_MESSAGE(same(lane(r, k), expected(a)), "of ", a);
        }
    }
}
template <class V, class Values, class Op, class Expected>
void check_pairs(const Values& values, Op op, Expected expected) {
    for (std::size_t i = 0; i + 16 < values.size(); ++i) {
        for (std::size_t j = 0; j + 16 < values.size(); ++j) {
            const auto r = op(load<V>(&values[i]), load<V>(&values[j]));
            for (int k = 0; k < lanes_of<V>; ++k) {
                const auto a = values[i + static_cast<std::size_t>(k)];
                const auto b = values[j + static_cast<std::size_t>(k)];
                CHECK_MESSAGE(same(lane(r, k), expected(a, b)), "of ", a, " and ", b);
            }
        }
    }
}
template <class V, class Values, class Op>
void check_pairs(const Values& values, Op op) {
    check_pairs<V>(values, op, op);
}

// Integer arithmetic modulo 2^32.
std::int32_t wrap(std::int64_t a) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(static_cast<std::uint64_t>(a)));
}

TEST_CASE_TEMPLATE("arithmetic of floats is IEEE 754's in every lane", F, float, ALL_LANES) {
    check_pairs<F>(floats, [](auto a, auto b) { return a + b; });
    check_pairs<F>(floats, [](auto a, auto b) { return a - b; });
    check_pairs<F>(floats, [](auto a, auto b) { return a * b; });
    check_pairs<F>(floats, [](auto a, auto b) { return a / b; });
    check_pairs<F>(
        floats,
        [](auto a, auto b) {
            a += b;
            a -= F(1.0F);
            a *= b;
            return a /= F(3.0F);
        },
        [](float a, float b) { return (a + b - 1.0F) * b / 3.0F; });
    check_each<F>(
        floats, [](auto a) { return -a; },
        [](float a) { return float_from_bits(bits_of(a) ^ least); });
    check_each<F>(
        floats, [](auto a) { return abs(a); }, [](float a) { return std::fabs(a); });
    check_each<F>(
        floats, [](auto a) { return sqrt(a); }, [](float a) { return std::sqrt(a); });
}

TEST_CASE_TEMPLATE("fma is the same on one lane as on many", F, ALL_LANES) {
    check_pairs<F>(
        floats, [](auto a, auto b) { return fma(a, b, 0.1F); },
        [](float a, float b) { return fma(a, b, 0.1F); });
    const float a = 1.0F + 0x1p-12F;  // a * a = 1 + 2^-11 + 2^-24: the last bit is lost in a float
    const float r = fma(a, a, -1.0F);
    CHECK((r == 0x1p-11F + 0x1p-24F || r == 0x1p-11F));
}

TEST_CASE_TEMPLATE("NaN compares as unequal, 0 as equal to -0", F, float, ALL_LANES) {
    check_pairs<F>(floats, [](auto a, auto b) { return a < b; });
    check_pairs<F>(floats, [](auto a, auto b) { return a > b; });
    check_pairs<F>(floats, [](auto a, auto b) { return a <= b; });
    check_pairs<F>(floats, [](auto a, auto b) { return a >= b; });
    check_pairs<F>(floats, [](auto a, auto b) { return a == b; });
    check_pairs<F>(floats, [](auto a, auto b) { return a != b; });
}

TEST_CASE_TEMPLATE("answers combine", F, float, ALL_LANES) {
    using M = MaskOf<F>;
    check_pairs<F>(
        floats, [](auto a, auto b) { return M((a < b) & (a > F(-3.0F))); },
        [](float a, float b) { return a < b && a > -3.0F; });
    check_pairs<F>(
        floats, [](auto a, auto b) { return M((a < b) | (b == F(1.0F))); },
        [](float a, float b) { return a < b || b == 1.0F; });
    check_pairs<F>(
        floats, [](auto a, auto b) { return !(a < b); }, [](float a, float b) { return !(a < b); });
    M both = iota<F>() < F(3.0F);
    both &= iota<F>() >= F(1.0F);
    CHECK(lane_bits(both) == (0b110U & ((1U << lanes_of<F>)-1U)));
    both |= iota<F>() == F(0.0F);
    CHECK(lane_bits(both) == (0b111U & ((1U << lanes_of<F>)-1U)));
}

TEST_CASE_TEMPLATE("any and all", F, float, ALL_LANES) {
    using M = MaskOf<F>;
    constexpr float n = lanes_of<F>;
    CHECK(any(M(true)));
    CHECK(all(M(true)));
    CHECK_FALSE(any(M(false)));
    CHECK_FALSE(all(M(false)));
    for (int k = 0; k < lanes_of<F>; ++k) {
        const M one = iota<F>() == F(static_cast<float>(k));
        CHECK(any(one));
        CHECK(all(one) == (n == 1.0F));
        CHECK(lane_bits(one) == 1U << k);
    }
}

TEST_CASE_TEMPLATE("select takes each lane from the side that its answer names", F, float,
                   ALL_LANES) {
    check_pairs<F>(
        floats, [](auto a, auto b) { return select(a < b, a, b); },
        [](float a, float b) { return a < b ? a : b; });
    check_pairs<F>(
        floats, [](auto a, auto b) { return select(a < b, 2.0F, b); },
        [](float a, float b) { return a < b ? 2.0F : b; });
    check_pairs<F>(
        floats, [](auto a, auto b) { return select(a < b, a, -0.0F); },
        [](float a, float b) { return a < b ? a : -0.0F; });
    check_pairs<F>(
        floats, [](auto a, auto b) { return F(select(a < b, 2.0F, 3.0F)); },
        [](float a, float b) { return a < b ? 2.0F : 3.0F; });
    check_pairs<IntOf<F>>(
        ints, [](auto a, auto b) { return select(a < b, a, 5); },
        [](std::int32_t a, std::int32_t b) { return a < b ? a : 5; });
}

TEST_CASE_TEMPLATE("min and max return the second where one is NaN or both are 0", F, float,
                   ALL_LANES) {
    check_pairs<F>(
        floats, [](auto a, auto b) { return min(a, b); },
        [](float a, float b) { return a < b ? a : b; });
    check_pairs<F>(
        floats, [](auto a, auto b) { return max(a, b); },
        [](float a, float b) { return a > b ? a : b; });
    CHECK(same(lane(max(F(nan), 0.0F), 0), 0.0F));
    CHECK(same(lane(min(F(1.0F), nan), 0), nan));
    check_pairs<IntOf<F>>(
        ints, [](auto a, auto b) { return min(a, b); },
        [](std::int32_t a, std::int32_t b) { return a < b ? a : b; });
    check_pairs<IntOf<F>>(
        ints, [](auto a, auto b) { return max(a, b); },
        [](std::int32_t a, std::int32_t b) { return a > b ? a : b; });
}

TEST_CASE_TEMPLATE("arithmetic of integers wraps", F, ALL_LANES) {
    using I = IntOf<F>;
    using Wide = std::int64_t;
    check_pairs<I>(
        ints, [](I a, I b) { return a + b; }, [](Wide a, Wide b) { return wrap(a + b); });
    check_pairs<I>(
        ints, [](I a, I b) { return a - b; }, [](Wide a, Wide b) { return wrap(a - b); });
    check_pairs<I>(
        ints, [](I a, I b) { return a * b; }, [](Wide a, Wide b) { return wrap(a * b); });
    check_pairs<I>(
        ints, [](I a, I b) { return (a += b) -= I(3); },
        [](Wide a, Wide b) { return wrap(a + b - 3); });
    check_each<I>(
        ints, [](I a) { return -a; }, [](Wide a) { return wrap(-a); });
}

TEST_CASE_TEMPLATE("integers compare, and combine bit by bit", F, float, ALL_LANES) {
    using I = IntOf<F>;
    check_pairs<I>(ints, [](auto a, auto b) { return a < b; });
    check_pairs<I>(ints, [](auto a, auto b) { return a > b; });
    check_pairs<I>(ints, [](auto a, auto b) { return a <= b; });
    check_pairs<I>(ints, [](auto a, auto b) { return a >= b; });
    check_pairs<I>(ints, [](auto a, auto b) { return a == b; });
    check_pairs<I>(ints, [](auto a, auto b) { return a != b; });
    check_pairs<I>(ints, [](auto a, auto b) { return a & b; });
    check_pairs<I>(ints, [](auto a, auto b) { return a | b; });
    check_pairs<I>(ints, [](auto a, auto b) { return a ^ b; });
    for (int bits = 0; bits < 32; ++bits) {
        check_each<I>(
            ints, [bits](auto a) { return a << bits; },
            [bits](std::int64_t a) { return wrap(a * (std::int64_t{1} << bits)); });
        check_each<I>(
            ints, [bits](auto a) { return a >> bits; },
            [bits](double a) { return wrap(std::llrint(std::floor(std::ldexp(a, -bits)))); });
    }
}

TEST_CASE_TEMPLATE("floats round to integers, ties to even", F, float, ALL_LANES) {
    constexpr auto values = repeated(
        std::array{0.5F, 1.5F, -0.5F, -1.5F, 2.5F, 2.4999998F, 2.5000002F, -0.0F, 8388607.5F,
                   -8388609.0F, 2147483520.0F, -2147483648.0F, 0.49999997F, 1e-40F});
    check_each<F>(
        values, [](auto a) { return round_to_int(a); },
        [](float a) { return static_cast<std::int32_t>(std::nearbyint(static_cast<double>(a))); });
    check_each<F>(
        values, [](auto a) { return truncate_to_int(a); },
        [](float a) { return static_cast<std::int32_t>(std::trunc(static_cast<double>(a))); });
}

TEST_CASE_TEMPLATE("integers become floats and bits", F, float, ALL_LANES) {
    using I = IntOf<F>;
    check_each<I>(
        ints, [](auto a) { return to_float(a); },
        [](std::int32_t a) { return static_cast<float>(static_cast<double>(a)); });
    check_each<I>(
        ints, [](auto a) { return bits_of(float_from_bits(a)); }, [](std::int32_t a) { return a; });
    CHECK(lane(bits_of(F(-2.0F)), lanes_of<F> - 1) == wrap(0xc0000000));
    CHECK(lane(float_from_bits(I(0x3f800000)), lanes_of<F> - 1) == 1.0F);
}

TEST_CASE_TEMPLATE("load and store any alignment", F, float, ALL_LANES) {
    using I = IntOf<F>;
    for (std::size_t at = 0; at < 11; ++at) {
        std::array<float, 40> to{};
        store(&to[at], load<F>(&floats[at]));
        std::array<std::int32_t, 40> ints_to{};
        store(&ints_to[at], load<I>(&ints[at]));
        for (std::size_t i = 0; i < to.size(); ++i) {
            const bool inside = i >= at && i < at + lanes_of<F>;
            CHECK(same(to[i], inside ? floats[i] : 0.0F));
            CHECK(ints_to[i] == (inside ? ints[i] : 0));
        }
    }
    for (int k = 0; k < lanes_of<F>; ++k) {
        CHECK(lane(iota<F>(), k) == static_cast<float>(k));
        CHECK(lane(iota<I>(), k) == k);
    }
}

TEST_CASE_TEMPLATE("gather and lookups read where the index says", F, float, ALL_LANES) {
    using I = IntOf<F>;
    std::array<float, 1000> table{};
    std::array<std::int32_t, 1000> numbers{};
    for (std::size_t i = 0; i < table.size(); ++i) {
        numbers[i] = 7 * static_cast<std::int32_t>(i);
        table[i] = 0.5F * static_cast<float>(i);
    }
    constexpr auto at = repeated(std::array<std::int32_t, 7>{0, 999, 1, 500, 15, 16, 17});
    check_each<I>(
        at, [&](auto i) { return gather(table.data(), i); },
        [](std::int32_t i) { return 0.5F * static_cast<float>(i); });
    check_each<I>(
        at, [&](auto i) { return gather(numbers.data(), i); },
        [](std::int32_t i) { return 7 * i; });
    for (std::int32_t first = 0; first < 48; ++first) {
        const auto r = lookup16(&table[3], iota<I>() + I(first));
        for (int k = 0; k < lanes_of<F>; ++k) {
            CHECK(lane(r, k) == 0.5F * static_cast<float>(3 + ((first + k) & 15)));
        }
        const auto two = lookup(&table[3], &table[500], iota<I>() * I(3) + I(first));
        for (int k = 0; k < lanes_of<F>; ++k) {
            const int index = (first + 3 * k) % (2 * lanes_of<F>);
            const int place = index < lanes_of<F> ? 3 + index : 500 + index - lanes_of<F>;
            CHECK(lane(two, k) == 0.5F * static_cast<float>(place));
        }
    }
}

TEST_CASE_TEMPLATE("reciprocal is off by less than 2 ulp, inverse_sqrt_estimate by 2^-14", F, float,
                   ALL_LANES) {
    double worst_quotient = 0;
    double worst_root = 0;
    for (int e = -126; e < 126; ++e) {
        for (int i = 0; i < 200; ++i) {
            const float x = std::ldexp(1.0F + static_cast<float>(i) / 200.0F, e);
            const double d = static_cast<double>(x);
            const double root{lane(inverse_sqrt_estimate(F(x)), lanes_of<F> - 1)};
            const double quotient{lane(reciprocal(F(x)), lanes_of<F> - 1)};
            worst_root = worse(worst_root, std::abs(root * std::sqrt(d) - 1.0));
            worst_quotient = worse(worst_quotient, std::abs(quotient * d - 1.0));
            CHECK(same(lane(inverse_sqrt_estimate(F(x)), 0), inverse_sqrt_estimate(x)));
            CHECK(same(lane(reciprocal(F(-x)), 0), reciprocal(-x)));
        }
    }
    CHECK(worst_quotient < 0x1p-23);
    CHECK(worst_root <= 0x1p-14);
}

TEST_CASE_TEMPLATE("difference_of_products is accurate where it cancels", F, float, ALL_LANES) {
    double worst = 0;
    for (int i = 1; i < 4000; ++i) {
        const float a = 1.0F + static_cast<float>(i) * 0x1p-12F;
        const float b = 3.0F - static_cast<float>(i) * 0x1.8p-14F;
        const float c = a * (1.0F + static_cast<float>(i % 7) * 0x1p-22F);
        const float d = b * (1.0F - static_cast<float>(i % 5) * 0x1p-22F);
        const double exact = static_cast<double>(a) * static_cast<double>(b) -
                             static_cast<double>(c) * static_cast<double>(d);
        const float r = lane(difference_of_products(F(a), F(b), F(c), F(d)), lanes_of<F> - 1);
        worst = std::max(
            worst, std::abs(static_cast<double>(r) - exact) / std::max(std::abs(exact), 1e-30));
        CHECK(same(r, difference_of_products(a, b, c, d)));
    }
    CHECK(worst < 0x1p-23);
}

TEST_CASE_TEMPLATE("FlushSubnormals makes small numbers 0 while it lives", F, float, ALL_LANES) {
    volatile float small = std::numeric_limits<float>::min();
    const auto half = [&] { return lane(F(small) * F(0.5F), lanes_of<F> - 1); };
    const auto doubled = [&] { return lane(F(small) * F(2.0F), lanes_of<F> - 1); };
    {
        const FlushSubnormals flush;
        CHECK(bits_of(half()) == 0);
        small = smallest;
        CHECK(bits_of(doubled()) == 0);
    }
    CHECK(bits_of(doubled()) == 2);
    small = std::numeric_limits<float>::min();
    CHECK(bits_of(half()) == 1 << 22);
}

TEST_CASE("the widest register is among the widths") {
    CHECK(lanes_of<float> == 1);
    CHECK(lanes_of<double> == 1);
    CHECK(lanes_of<Float<max_lanes>> == max_lanes);
    CHECK((std::is_same_v<MaskOf<Float4>, Mask<4>>));
    CHECK((std::is_same_v<IntOf<double>, std::int32_t>));
}

}  // namespace
}  // namespace glint
