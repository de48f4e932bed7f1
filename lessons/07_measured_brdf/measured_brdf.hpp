// Lesson 7: a BRDF that nobody derived: a table of what was measured, looked up by angles.
//
//     H = normalize(L + V)     theta_half: from N to H     theta_difference: from H to L
//     phi_difference: how far L is turned about H            (Rusinkiewicz 1998)
//
// Swapping L and V turns phi_difference by 180 degrees, a mirror makes it its negative: 0 to 90
// degrees are all that a reciprocal table needs.
#pragma once

#include "lessons/07_measured_brdf/brdf_table.hpp"
#include "framework/math/angle.hpp"
#include "framework/math/incidence.hpp"

#include <memory>

namespace glint {

// The angle of this cosine and this sine squared, 0..1 for 0 to 90 degrees.
template <Real T>
T share_of_right_angle(const T& cosine, const T& sin2) {
    return acute_angle(cosine, sin2) * T(2 / std::numbers::pi);
}

// Where two directions are in the table, 0..1 on each axis.
template <Real T>
Vec3<T> place_in_table(const Incidence<T>& g) {
    const T LH = l_dot_h(g);
    // SOLUTION 07.1
    const T NH = (g.NL + g.NV) / max(2.0F * LH, T(1e-20F));  // |L + V| = 2 L.H
    // HANDOUT
    // const T NH = max(g.NL, g.NV);  // TODO 07.1: H is half way between L and V
    // END
    const T theta_half = share_of_right_angle(NH, sin2_half(g));
    // N.V - N.L = 2 sin(theta_half) sin(theta_difference) cos(phi_difference)
    const T sines = sqrt(max(sin2_half(g) * (T(2.0F) - 2.0F * g.LV), T(1e-20F)));
    const T cos_phi = min(abs(g.NV - g.NL) / sines, T(1.0F));
    const T phi = share_of_right_angle(cos_phi, T(1.0F) - cos_phi * cos_phi);
    // SOLUTION 07.2
    const T stretched = sqrt(theta_half);  // highlights are where it is small
    // HANDOUT
    // const T stretched = theta_half;  // TODO 07.2: the table has its square root
    // END
    return {stretched, share_of_right_angle(LH, T(0.5F) - T(0.5F) * g.LV), phi};
}

struct MeasuredBrdf {
    std::shared_ptr<const BrdfTable> table;

    template <Real T>
    Rgb<T> operator()(const Incidence<T>& g) const {
        const Vec3<T> place = place_in_table(g);
        const Neighbours<T> h(place.x, table->half);
        const Neighbours<T> d(place.y, table->difference);
        const Neighbours<T> a(place.z, table->azimuth);
        // SOLUTION 07.3
        using I = IntOf<T>;
        const auto between_a = [&](const I& i, const I& j) {
            return mix(table->at<T>(i, j, a.low), table->at<T>(i, j, a.high), Rgb<T>(a.share));
        };
        const auto between_d = [&](const I& i) {
            return mix(between_a(i, d.low), between_a(i, d.high), Rgb<T>(d.share));
        };
        return mix(between_d(h.low), between_d(h.high), Rgb<T>(h.share));
        // HANDOUT
        // return table->at<T>(h.low, d.low, a.low);  // TODO 07.3: between the cells
        // END
    }
    Rgb<float> ambient_albedo() const { return table->ambient_albedo; }
};

}  // namespace glint
