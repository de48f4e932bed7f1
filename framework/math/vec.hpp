// Real numbers and vectors of them. A text templated on Real T runs as float, as double (the
// reference that accuracy is measured against) and as 4, 8 or 16 lanes of float.
//
// GLM's dot, cross, normalize, length, reflect and mix work on all of them. normalize() of a zero
// vector is NaN, as in GLSL; normalize_or() says what else it shall be.
#pragma once

#include "framework/math/one_lane.hpp"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <concepts>
#include <limits>

namespace glint {

template <class T>
concept Real = std::same_as<T, float> || std::same_as<T, double> || is_lanes<T>;

template <class T>
using Vec2 = glm::vec<2, T>;
template <class T>
using Vec3 = glm::vec<3, T>;
template <class T>
using Vec4 = glm::vec<4, T>;
template <class T>
using Rgb = glm::vec<3, T>;  // linear radiometric values of the sRGB primaries

// Uniforms are floats, and a literal may be an int or, among lanes, a double; together with the
// shader's number type they need no cast.
template <class A, class B>
concept Widens = Real<A> && !std::same_as<A, B> && (std::same_as<B, float> || std::integral<B> ||
                                                    (is_lanes<A> && std::same_as<B, double>));
template <class A, class B>
concept Mixed = Widens<A, B> || Widens<B, A>;
template <class A, class B>
using WiderOf = std::conditional_t<Widens<A, B>, A, B>;
template <int L, class A, class B>
using WiderVec = glm::vec<L, WiderOf<A, B>>;

template <int L, Real A, Real B>
requires Mixed<A, B>
auto operator+(const glm::vec<L, A>& a, const glm::vec<L, B>& b) {
    return WiderVec<L, A, B>(a) + WiderVec<L, A, B>(b);
}
template <int L, Real A, class B>
requires Mixed<A, B>
auto operator+(const glm::vec<L, A>& a, const B& b) {
    return WiderVec<L, A, B>(a) + WiderOf<A, B>(b);
}
template <int L, class A, Real B>
requires Mixed<A, B>
auto operator+(const A& a, const glm::vec<L, B>& b) {
    return WiderOf<A, B>(a) + WiderVec<L, A, B>(b);
}

template <int L, Real A, Real B>
requires Mixed<A, B>
auto operator-(const glm::vec<L, A>& a, const glm::vec<L, B>& b) {
    return WiderVec<L, A, B>(a) - WiderVec<L, A, B>(b);
}
template <int L, Real A, class B>
requires Mixed<A, B>
auto operator-(const glm::vec<L, A>& a, const B& b) {
    return WiderVec<L, A, B>(a) - WiderOf<A, B>(b);
}
template <int L, class A, Real B>
requires Mixed<A, B>
auto operator-(const A& a, const glm::vec<L, B>& b) {
    return WiderOf<A, B>(a) - WiderVec<L, A, B>(b);
}

template <int L, Real A, Real B>
requires Mixed<A, B>
auto operator*(const glm::vec<L, A>& a, const glm::vec<L, B>& b) {
    return WiderVec<L, A, B>(a) * WiderVec<L, A, B>(b);
}
template <int L, Real A, class B>
requires Mixed<A, B>
auto operator*(const glm::vec<L, A>& a, const B& b) {
    return WiderVec<L, A, B>(a) * WiderOf<A, B>(b);
}
template <int L, class A, Real B>
requires Mixed<A, B>
auto operator*(const A& a, const glm::vec<L, B>& b) {
    return WiderOf<A, B>(a) * WiderVec<L, A, B>(b);
}

template <int L, Real A, Real B>
requires Mixed<A, B>
auto operator/(const glm::vec<L, A>& a, const glm::vec<L, B>& b) {
    return WiderVec<L, A, B>(a) / WiderVec<L, A, B>(b);
}
template <int L, Real A, class B>
requires Mixed<A, B>
auto operator/(const glm::vec<L, A>& a, const B& b) {
    return WiderVec<L, A, B>(a) / WiderOf<A, B>(b);
}
template <int L, class A, Real B>
requires Mixed<A, B>
auto operator/(const A& a, const glm::vec<L, B>& b) {
    return WiderOf<A, B>(a) / WiderVec<L, A, B>(b);
}

// x limited to [low, high]; low where x is NaN.
template <Real T>
T clamp(T x, std::type_identity_t<T> low, std::type_identity_t<T> high) {
    return min(max(x, low), high);
}

template <int L, Real T>
glm::vec<L, T> select(const MaskOf<T>& m, const glm::vec<L, T>& yes, const glm::vec<L, T>& no) {
    glm::vec<L, T> r;
    for (int i = 0; i < L; ++i) {
        r[i] = select(m, yes[i], no[i]);
    }
    return r;
}

template <int L, Real T>
glm::vec<L, T> min(const glm::vec<L, T>& a, const glm::vec<L, T>& b) {
    glm::vec<L, T> r;
    for (int i = 0; i < L; ++i) {
        r[i] = min(a[i], b[i]);
    }
    return r;
}

template <int L, Real T>
glm::vec<L, T> max(const glm::vec<L, T>& a, const glm::vec<L, T>& b) {
    glm::vec<L, T> r;
    for (int i = 0; i < L; ++i) {
        r[i] = max(a[i], b[i]);
    }
    return r;
}

// v scaled to length 1 by an estimate of 1/|v|, which a step of Newton's iteration mends.
template <int L, Real T>
glm::vec<L, T> scaled_to_one(const glm::vec<L, T>& v, const T& square, const T& estimate) {
    const T missing = fma(-(square * estimate), estimate, T(1.0F));
    return v * fma(missing * T(0.5F), estimate, estimate);
}

// As GLM's, which asks for a root and a quotient: v scaled to length 1, NaN where v is zero.
template <int L, Real T>
glm::vec<L, T> normalize(const glm::vec<L, T>& v) {
    const T square = dot(v, v);
    return scaled_to_one(v, square, inverse_sqrt_estimate(square));
}

// v scaled to length 1; fallback where v is zero, not finite, or so short or long that the square
// of its length leaves the range of T.
template <Real T>
Vec3<T> normalize_or(const Vec3<T>& v, const Vec3<T>& fallback) {
    constexpr auto least = std::numeric_limits<T>::min();
    constexpr auto most = std::numeric_limits<T>::max();
    const T square = dot(v, v);
    const MaskOf<T> usable = (square >= T(least)) & (square <= T(most));
    return select(usable, scaled_to_one(v, square, inverse_sqrt_estimate(square)), fallback);
}

}  // namespace glint
