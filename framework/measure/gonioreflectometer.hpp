// The virtual gonioreflectometer: measures what a BRDF says, whoever wrote it. A BRDF is a functor,
// Rgb<T> operator()(const Incidence<T>&) const in 1/sr, asked for light above the horizon. All
// measurements are in double.
#pragma once

#include "framework/measure/quadrature.hpp"
#include "framework/math/incidence.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glint {

// Which of the two directions stands still while the other runs over the hemisphere.
enum class Fixed { light, view };

namespace gonio_detail {

// Cuts of the angle from the mirror direction, ever finer towards it: between two of them even a
// lobe of exponent 1e7 is smooth. And towards the right angle, where a lobe whose exponent is below
// 1 ends with an infinite slope.
inline std::vector<double> cuts() {
    std::vector<double> at{0};
    for (double a = 1e-5; a < std::numbers::pi / 2; a *= 1.6) {
        at.push_back(a);
    }
    for (double a = 1e-8; a < 0.5; a *= 4) {
        at.push_back(std::numbers::pi / 2 - a);
    }
    at.push_back(std::numbers::pi / 2);
    at.push_back(std::numbers::pi);
    return at;
}

}  // namespace gonio_detail

// The share of light that is reflected: with the light fixed at cos_fixed from the normal, the
// integral of BRDF(L, V) cos(theta_V) over all V, which energy conservation holds below 1; with the
// viewer fixed, over all L, the radiance in a white furnace. 0 < cos_fixed <= 1.
//
// The integral runs in polar coordinates about the mirror direction of the fixed one, where lobes
// have their peak, and over just those angles that are above the horizon, so that the integrand is
// smooth: to 1e-8 for the models of the lessons, exponents 0 to 1e7.
template <class Brdf>
Rgb<double> directional_albedo(const Brdf& brdf, double cos_fixed, Fixed fixed = Fixed::light) {
    static const Quadrature rule = gauss_legendre(24);
    static const std::vector<double> cuts = gonio_detail::cuts();
    const double sin_fixed = std::sqrt(std::max(0.0, 1 - cos_fixed * cos_fixed));
    const auto ring = [&](double angle) {  // the directions at this angle from the mirror direction
        const double up = std::cos(angle) * cos_fixed;
        const double side = std::sin(angle) * sin_fixed;
        if (up + side <= 0) {
            return Rgb<double>(0);
        }
        const double end = up >= side ? std::numbers::pi : std::acos(-up / side);
        const auto value = [&](double azimuth) {
            const double cosine = up + side * std::cos(azimuth);
            const double LV = 2 * cos_fixed * cosine - std::cos(angle);
            const Incidence<double> g = fixed == Fixed::light
                                            ? Incidence<double>{cos_fixed, cosine, LV}
                                            : Incidence<double>{cosine, cos_fixed, LV};
            return brdf(g) * std::max(cosine, 0.0);
        };
        return 2.0 * std::sin(angle) * integrate(rule, 0, end, value);
    };
    // Where the horizon first and last cuts the rings, they change their form.
    std::vector<double> at = cuts;
    const double above = std::numbers::pi / 2 - std::acos(std::min(cos_fixed, 1.0));
    at.push_back(std::max(above, 0.0));
    at.push_back(std::numbers::pi - std::max(above, 0.0));
    std::sort(at.begin(), at.end());
    Rgb<double> sum(0);
    for (std::size_t i = 0; i + 1 < at.size(); ++i) {
        sum += integrate(rule, at[i], at[i + 1], ring);
    }
    return sum;
}

// BRDF(L, V) - BRDF(V, L): zero for what obeys Helmholtz reciprocity.
template <class Brdf, Real T>
Rgb<T> reciprocity_error(const Brdf& brdf, const Incidence<T>& g) {
    return brdf(g) - brdf(Incidence<T>{g.NV, g.NL, g.LV});
}

// The directions at polar angles theta_L and theta_V from the normal, azimuth apart from each
// other; radians.
inline Incidence<double> incidence_of_angles(double theta_L, double theta_V, double azimuth) {
    const double NL = std::cos(theta_L);
    const double NV = std::cos(theta_V);
    return {NL, NV, NL * NV + std::sin(theta_L) * std::sin(theta_V) * std::cos(azimuth)};
}

}  // namespace glint
