#include "framework/math/vec.hpp"

#include "tests/unit/math/lane_types.hpp"
#include "tests/worst.hpp"

#include <doctest/doctest.h>

#include <array>
#include <type_traits>

namespace glint {
namespace {

using glint::lane;
using glint::same;

// Lane k of a vector of lanes.
template <int L, class T>
glm::vec<L, float> lane(const glm::vec<L, T>& v, int k) {
    glm::vec<L, float> r;
    for (int i = 0; i < L; ++i) {
        r[i] = lane(v[i], k);
    }
    return r;
}

template <int L>
bool same(const glm::vec<L, float>& a, const glm::vec<L, float>& b) {
    bool all_same = true;
    for (int i = 0; i < L; ++i) {
        all_same = all_same && same(a[i], b[i]);
    }
    return all_same;
}

// Different in every lane and component.
template <int L, class T>
glm::vec<L, T> some_vector(float seed) {
    glm::vec<L, T> v;
    for (int i = 0; i < L; ++i) {
        v[i] = T(seed) + iota<T>() * T(0.75F) - T(static_cast<float>(i) * 1.5F);
    }
    return v;
}

// What op does to lanes, it does to each of them alone.
template <class F, class Op, class... Arguments>
void check_lanes(Op op, const Arguments&... arguments) {
    const auto r = op(arguments...);
    for (int k = 0; k < lanes_of<F>; ++k) {
        CHECK(same(lane(r, k), op(lane(arguments, k)...)));
    }
}

template <int L, class T>
void check_mixed_operators() {
    using V = glm::vec<L, T>;
    const V v = some_vector<L, T>(2.0F);
    const V w(0.5F);
    const T x = T(3.0F) + iota<T>();
    const glm::vec<L, float> u = some_vector<L, float>(4.0F);
    const auto equal = [](const auto& a, const V& b) {
        static_assert(std::is_same_v<std::decay_t<decltype(a)>, V>);
        for (int i = 0; i < L; ++i) {
            CHECK(all(a[i] == b[i]));
        }
    };
    equal(u + v, V(u) + v);
    equal(v + u, v + V(u));
    equal(u - v, V(u) - v);
    equal(v - u, v - V(u));
    equal(u * v, V(u) * v);
    equal(v * u, v * V(u));
    equal(u / v, V(u) / v);
    equal(v / u, v / V(u));
    equal(u + x, V(u) + x);
    equal(x - u, x - V(u));
    equal(x * u, x * V(u));
    equal(u / x, V(u) / x);
    equal(v + 0.25F, v + T(0.25F));
    equal(0.25F - v, T(0.25F) - v);
    equal(v * 0.25F, v * T(0.25F));
    equal(0.25F / v, T(0.25F) / v);
    equal(v + 1, v + T(1.0F));
    equal(1 - v, T(1.0F) - v);
    equal(2 * v, T(2.0F) * v);
    equal(v / 2, v / T(2.0F));
    equal(v * 0.5, v * w);
    V sum = v;
    sum += u;
    sum *= 2.0F;
    equal(sum, (v + V(u)) * T(2.0F));
}

TEST_CASE_TEMPLATE("uniforms mix with vectors of every length", T, double, ALL_LANES) {
    check_mixed_operators<2, T>();
    check_mixed_operators<3, T>();
    check_mixed_operators<4, T>();
    const glm::vec3 floats = 2 * glm::vec3(1.0F) - 1;
    CHECK(floats == glm::vec3(1.0F));
}

TEST_CASE_TEMPLATE("GLM's functions do to lanes what they do to scalars", F, ALL_LANES) {
    const auto a = some_vector<3, F>(2.0F);
    const auto b = some_vector<3, F>(-7.3F);
    const F t = iota<F>() * F(0.1F);
    check_lanes<F>([](const auto& v, const auto& w) { return dot(v, w); }, a, b);
    check_lanes<F>([](const auto& v, const auto& w) { return cross(v, w); }, a, b);
    check_lanes<F>([](const auto& v) { return normalize(v); }, a);
    check_lanes<F>([](const auto& v) { return length(v); }, a);
    check_lanes<F>([](const auto& v, const auto& w) { return reflect(v, normalize(w)); }, a, b);
    check_lanes<F>([](const auto& v, const auto& w, auto s) { return mix(v, w, s); }, a, b, t);
    check_lanes<F>([](const auto& v, const auto& w) { return dot(v, w); }, some_vector<4, F>(1.0F),
                   some_vector<4, F>(3.3F));
}

TEST_CASE_TEMPLATE("normalize comes within 1.5e-7 of the direction, and of length 1", F, float,
                   ALL_LANES) {
    double worst_length = 0;
    double worst_component = 0;
    for (int i = 0; i < 20000; ++i) {
        const float t = static_cast<float>(i);
        const glm::vec3 v(std::sin(t), std::sin(1.7F * t), std::sin(0.3F * t) + 0.1F);
        const glm::dvec3 n(lane(normalize(Vec3<F>(v * std::exp2(0.001F * t))), lanes_of<F> - 1));
        worst_length = worse(worst_length, std::abs(glm::length(n) - 1.0));
        const glm::dvec3 off = n - glm::normalize(glm::dvec3(v));
        for (const double component : {off.x, off.y, off.z}) {
            worst_component = worse(worst_component, std::abs(component));
        }
    }
    CHECK(worst_length < 1.5e-7);
    CHECK(worst_component < 1.5e-7);
}

TEST_CASE_TEMPLATE("select, min and max go component by component", F, float, ALL_LANES) {
    const auto a = some_vector<3, F>(2.0F);
    const auto b = some_vector<3, F>(1.9F) * -1.0F;
    const auto m = iota<F>() < F(2.0F);
    const auto chosen = select(MaskOf<F>(m), a, b);
    const auto low = min(a, b);
    const auto high = max(a, Vec3<F>(0.0F));
    for (int k = 0; k < lanes_of<F>; ++k) {
        CHECK(same(lane(chosen, k), k < 2 ? lane(a, k) : lane(b, k)));
        CHECK(same(lane(low, k), glm::min(lane(a, k), lane(b, k))));
        CHECK(same(lane(high, k), glm::max(lane(a, k), glm::vec3(0.0F))));
    }
}

TEST_CASE_TEMPLATE("clamp turns NaN into the low end", F, float, ALL_LANES) {
    const auto clamped = [](float x) { return lane(clamp(F(x), -1.0F, 2.0F), lanes_of<F> - 1); };
    CHECK(clamped(0.5F) == 0.5F);
    CHECK(clamped(-3.0F) == -1.0F);
    CHECK(clamped(3.0F) == 2.0F);
    CHECK(clamped(nan) == -1.0F);
    CHECK(clamped(infinity) == 2.0F);
    CHECK(clamped(-infinity) == -1.0F);
}

TEST_CASE_TEMPLATE("normalize_or falls back where there is no direction", F, float, ALL_LANES) {
    const Vec3<float> up(0.0F, 0.0F, 1.0F);
    const auto direction = [&](glm::vec3 v) {
        return lane(normalize_or(Vec3<F>(v), Vec3<F>(up)), lanes_of<F> - 1);
    };
    CHECK(direction({3.0F, 0.0F, -4.0F}) == glm::vec3(0.6F, 0.0F, -0.8F));
    CHECK(length(direction({1e-18F, 1e-18F, 0.0F})) == doctest::Approx(1.0));
    CHECK(length(direction({1e18F, 0.0F, 1e18F})) == doctest::Approx(1.0));
    for (const float bad : {0.0F, -0.0F, 1e-30F, 1e-45F, 1e30F, nan, infinity, -infinity}) {
        CHECK(direction(glm::vec3(bad)) == up);
    }
    CHECK(direction({1.0F, nan, 0.0F}) == up);
}

TEST_CASE("normalize_or of doubles reaches further") {
    const Vec3<double> up(0.0, 0.0, 1.0);
    CHECK(normalize_or(Vec3<double>(1e-30, 0.0, 0.0), up) == Vec3<double>(1.0, 0.0, 0.0));
    CHECK(normalize_or(Vec3<double>(0.0), up) == up);
}

TEST_CASE("a vector of lanes is nothing but its lanes") {
    CHECK(sizeof(Vec3<Float16>) == sizeof(float) * 3 * lanes_of<Float16>);
    CHECK(std::is_trivially_copyable_v<Vec3<Float16>>);
}

}  // namespace
}  // namespace glint
