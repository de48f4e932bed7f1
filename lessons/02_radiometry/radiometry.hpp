// Lesson 2: radiometry - what light is counted in.
//
//     radiance    L  W/(m^2 sr)  along a ray: power per area across it and per solid angle
//     irradiance  E  W/m^2       that arrives: integral over the hemisphere of L cos(theta) d omega
//     exitance    M  W/m^2       that leaves, by the same integral
#pragma once

#include "framework/math/vec.hpp"

#include <cmath>
#include <numbers>

namespace glint {

inline double plane_angle(double arc, double radius) {  // rad
    return arc / radius;
}
inline double solid_angle(double area, double radius) {  // sr, of an area on a sphere
    return area / (radius * radius);
}

// d omega of the patch d_theta x d_phi at the angle theta from the pole.
inline double differential_solid_angle(double theta, double d_theta, double d_phi) {
    // SOLUTION 02.1
    return std::sin(theta) * d_theta * d_phi;
    // HANDOUT
    // return theta < 0 ? 0 : d_theta * d_phi;  // TODO 02.1: it is no square
    // END
}

// Integral of f(theta, phi) d omega over the hemisphere: rings x 4 rings patches, f at the middle.
template <class F>
double hemisphere_integral(int rings, F&& f) {
    const double step = plane_angle(std::numbers::pi / 2, 1) / rings;
    double sum = 0;
    for (int i = 0; i < rings; ++i) {
        for (int j = 0; j < 4 * rings; ++j) {
            const double theta = (i + 0.5) * step;
            sum += f(theta, (j + 0.5) * step) * differential_solid_angle(theta, step, step);
        }
    }
    return sum;
}

// Irradiance by radiance L(theta, phi); the exitance, where L leaves.
template <class L>
double irradiance(int rings, L&& radiance) {
    return hemisphere_integral(rings, [&](double theta, double phi) {
        // SOLUTION 02.2
        return radiance(theta, phi) * std::cos(theta);
        // HANDOUT
        // return radiance(theta, phi);  // TODO 02.2: how much of a beam meets the surface?
        // END
    });
}

// Irradiance by a disk lamp that faces down, over pi times its radiance, at a point so far below
// its plane and aside from its axis: {on a surface that faces the axis, on one that faces up}. The
// part of this vector along a normal that has the whole disk above its horizon is what arrives
// there. 0 where below <= 0.
template <Real T>
Vec2<T> irradiance_of_disk(const T& radius, const T& below, const T& aside) {
    const T h2 = below * below;
    const T r2 = radius * radius;
    const T p = (aside - radius) * (aside + radius) + h2;
    const T near = (aside - radius) * (aside - radius) + h2;  // square of the rim's distance
    const T far = (aside + radius) * (aside + radius) + h2;
    const T q = max(sqrt(near) * sqrt(far), T(1e-30F));  // cos(gamma) = p / q
    // SOLUTION 02.3
    const T up = select(p > T(0.0F), 2.0F * r2 * h2 / (q * (q + p)), 0.5F - 0.5F * p / q);
    // HANDOUT
    // const T up = r2 * h2 / (q * q);  // TODO 02.3: sin^2(gamma/2)
    // END
    const T inward = 2.0F * r2 * below * aside / (q * (q + p + 2.0F * r2));
    const auto lit = below > T(0.0F);
    return Vec2<T>(select(lit, inward, T(0.0F)), select(lit, up, T(0.0F)));
}

}  // namespace glint
