// Polynomials of as few terms as one likes.
#pragma once

#include "framework/math/vec.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace glint::charts {

// c0, c1, ... of the polynomial that meets f at Chebyshev's nodes of a..b: its largest error is
// within a small factor of the least that there is for its degree.
template <std::size_t Terms, class F>
std::array<float, Terms> fit(F f, double a, double b) {
    std::array<double, Terms> x{};
    std::array<double, Terms> d{};  // Newton's divided differences
    for (std::size_t i = 0; i < Terms; ++i) {
        const double angle = std::numbers::pi * (static_cast<double>(i) + 0.5) / Terms;
        x[i] = (a + b) / 2 + (b - a) / 2 * std::cos(angle);
        d[i] = f(x[i]);
    }
    for (std::size_t order = 1; order < Terms; ++order) {
        for (std::size_t i = Terms - 1; i >= order; --i) {
            d[i] = (d[i] - d[i - 1]) / (x[i] - x[i - order]);
        }
    }
    std::array<double, Terms> c{};
    for (std::size_t i = Terms; i-- > 0;) {  // c = c (t - x_i) + d_i
        for (std::size_t k = Terms - 1; k > 0; --k) {
            c[k] = c[k - 1] - x[i] * c[k];
        }
        c[0] = d[i] - x[i] * c[0];
    }
    std::array<float, Terms> rounded{};
    for (std::size_t i = 0; i < Terms; ++i) {
        rounded[i] = static_cast<float>(c[i]);
    }
    return rounded;
}

// c0 + c1 x + ... by Horner's rule.
template <Real T, std::size_t Terms>
T polynomial_of(const T& x, const std::array<float, Terms>& c) {
    T sum(c[Terms - 1]);
    for (std::size_t k = Terms - 1; k-- > 0;) {
        sum = fma(sum, x, T(c[k]));
    }
    return sum;
}

}  // namespace glint::charts
