// A number that counts what is done to it: the shading of one fragment, run with it, tells how many
// floating-point operations it takes. Sum, product, quotient, root, minimum, maximum and select
// count one each, a fused multiply-add two; comparisons and integers are not counted.
#pragma once

#include "framework/math/incidence.hpp"

#include <cmath>
#include <cstdint>

namespace glint {

struct Counted {
    struct Answer {
        bool yes;
        friend Answer operator&(Answer a, Answer b) { return {a.yes && b.yes}; }
        friend Answer operator|(Answer a, Answer b) { return {a.yes || b.yes}; }
        friend bool all(Answer a) { return a.yes; }
        friend bool any(Answer a) { return a.yes; }
        friend std::int32_t select(Answer m, std::int32_t a, std::int32_t b) {
            return m.yes ? a : b;
        }
    };

    float value;
    inline static std::int64_t operations = 0;

    Counted() = default;
    Counted(float v) : value(v) {}
    explicit Counted(double v) : value(static_cast<float>(v)) {}
    explicit Counted(int v) : value(static_cast<float>(v)) {}

    static Counted counted(float result, int count = 1) {
        operations += count;
        return result;
    }
    friend Counted operator+(Counted a, Counted b) { return counted(a.value + b.value); }
    friend Counted operator-(Counted a, Counted b) { return counted(a.value - b.value); }
    friend Counted operator*(Counted a, Counted b) { return counted(a.value * b.value); }
    friend Counted operator/(Counted a, Counted b) { return counted(a.value / b.value); }
    friend Counted operator-(Counted a) { return -a.value; }
    friend Answer operator<(Counted a, Counted b) { return {a.value < b.value}; }
    friend Answer operator>(Counted a, Counted b) { return {a.value > b.value}; }
    friend Answer operator<=(Counted a, Counted b) { return {a.value <= b.value}; }
    friend Answer operator>=(Counted a, Counted b) { return {a.value >= b.value}; }
    friend Answer operator==(Counted a, Counted b) { return {a.value == b.value}; }
    Counted& operator+=(Counted b) { return *this = *this + b; }
    Counted& operator-=(Counted b) { return *this = *this - b; }
    Counted& operator*=(Counted b) { return *this = *this * b; }
    Counted& operator/=(Counted b) { return *this = *this / b; }

    friend Counted min(Counted a, Counted b) { return counted(glint::min(a.value, b.value)); }
    friend Counted max(Counted a, Counted b) { return counted(glint::max(a.value, b.value)); }
    friend Counted sqrt(Counted a) { return counted(std::sqrt(a.value)); }
    friend Counted inverse_sqrt_estimate(Counted a) { return counted(1 / std::sqrt(a.value)); }
    friend Counted select(Answer m, Counted a, Counted b) {
        return counted(m.yes ? a.value : b.value);
    }
    friend Counted fma(Counted a, Counted b, Counted c) {
        return counted(glint::fma(a.value, b.value, c.value), 2);
    }
    friend Counted scale(Counted a, Counted k) { return counted(glint::scale(a.value, k.value)); }
    friend Counted abs(Counted a) { return std::abs(a.value); }
    friend float first_lane(Counted a) { return a.value; }
    friend std::int32_t bits_of(Counted a) { return glint::bits_of(a.value); }
};

template <>
inline constexpr bool is_lanes<Counted> = true;
template <>
struct Companions<Counted> {
    using Int = std::int32_t;
    using Mask = Counted::Answer;
};

// V.R by the cosines alone; the better one is computed only where a highlight shows.
template <>
inline Incidence<Counted> incidence(const Vec3<Counted>& N, const Vec3<Counted>& L,
                                    const Vec3<Counted>& V) {
    return {dot(N, L), dot(N, V), dot(L, V), Counted(0.0F), Counted(0.0F)};
}

}  // namespace glint

template <>
struct std::numeric_limits<glint::Counted> : std::numeric_limits<float> {};
