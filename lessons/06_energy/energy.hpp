// Lesson 6: energy conservation - no more light leaves than arrives, whatever direction it comes
// from:
//
//     albedo(L) = integral over the hemisphere of f(L, V) cos(theta_V) d omega_V <= 1
//
// For a reciprocal BRDF it is also what a viewer in direction L sees of the surface in a white
// furnace, where radiance 1 comes from everywhere.
#pragma once

#include "lessons/02_radiometry/radiometry.hpp"
#include "framework/measure/gonioreflectometer.hpp"

namespace glint {

// The share of light from theta (radians from the normal) that is reflected, green standing for
// all: what leaves towards (theta_out, phi), by lesson 2's sum over rings x 4 rings patches.
template <class Brdf>
double albedo(const Brdf& brdf, double theta, int rings) {
    const auto radiance = [&](double theta_out, double phi) {
        return brdf(incidence_of_angles(theta, theta_out, phi)).g;
    };
    // SOLUTION 06.1
    return irradiance(rings, radiance);
    // HANDOUT
    // return hemisphere_integral(rings, radiance);  // TODO 06.1: how is radiance counted?
    // END
}

// The albedo of (V.R)^n along the normal, where V.R = cos(theta), in closed form; n >= 0.
inline double phong_albedo_along_normal(double n) {
    // SOLUTION 06.2
    return 2 * std::numbers::pi / (n + 2);
    // HANDOUT
    // return n < 0 ? 0 : std::numbers::pi;  // TODO 06.2: that is n = 0 only
    // END
}

// Whether no more leaves than arrives, at every angle; to a thousandth, for the integral is a sum.
template <class Brdf>
bool conserves_energy(const Brdf& brdf, int rings) {
    double most = 0;
    for (int degrees = 0; degrees < 90; ++degrees) {
        const double theta = degrees * std::numbers::pi / 180;
        // SOLUTION 06.3
        most = std::max(most, albedo(brdf, theta, rings));
        // HANDOUT
        // most = theta > 0 ? most : albedo(brdf, theta, rings);  // TODO 06.3: at every angle
        // END
    }
    return most <= 1.001;
}

}  // namespace glint
