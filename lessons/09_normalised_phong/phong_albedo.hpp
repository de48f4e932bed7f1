// The share of light that the normalised lobe (n + 2)/(2 pi) max(V.R, 0)^n reflects, in closed
// form. With a = n/2 + 1 and the regularised incomplete beta function I:
//
//     A(theta, n) = c (1 + I_{c^2}(1/2, a)) / 2 + s^(2a) / ((2a - 1) B(a, 1/2))
//
//     c = cos(theta), s = sin(theta)        along the normal 1, near grazing cos(theta) and above
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glint {

namespace albedo_detail {

// 1 / B(a, 1/2) = Gamma(a + 1/2) / (Gamma(a) sqrt(pi)), a >= 1.
inline double inverse_beta(double a) {
    const double root_pi = 1 / std::numbers::inv_sqrtpi;
    if (a < 32) {
        return std::tgamma(a + 0.5) / (std::tgamma(a) * root_pi);
    }
    const double w = a - 0.25;  // about here the series has even powers only
    const double u = 1 / (w * w);
    const double series = 1 + u * (1.0 / 64 - u * (19.0 / 8192 - u * (631.0 / 524288)));
    return std::sqrt(w) * series / root_pi;
}

// 1 + z (a + 1/2)/b + z^2 (a + 1/2)(a + 3/2)/(b (b + 1)) + ...: every term is positive.
inline double positive_series(double a, double b, double z) {
    double sum = 1;
    double term = 1;
    for (double k = 0; term > 1e-17 * sum; ++k) {
        term *= z * (a + 0.5 + k) / (b + k);
        sum += term;
    }
    return sum;
}

}  // namespace albedo_detail

// For exponents n = 0 to 1e7 and cos_theta = 0 to 1, which is clamped; to a relative error of
// 1e-13.
inline double phong_albedo(double n, double cos_theta) {
    const double c = std::clamp(cos_theta, 0.0, 1.0);
    const double a = 0.5 * n + 1;
    const double power = std::exp(a * std::log1p(-c * c));  // s^(2a)
    const double weight = power * albedo_detail::inverse_beta(a);
    double I = 1;
    if (power > 1e-20) {
        I = c * c < 0.5
                ? 2 * c * weight * albedo_detail::positive_series(a, 1.5, c * c)
                : 1 - c * weight / a * albedo_detail::positive_series(a, a + 1, (1 - c) * (1 + c));
    }
    return c * (1 + I) / 2 + weight / (2 * a - 1);
}

}  // namespace glint
