// From BRDFs to tables and back: the gonioreflectometer writes down what it measures.
#pragma once

#include "lessons/07_measured_brdf/measured_brdf.hpp"
#include "framework/app/merl.hpp"
#include "framework/measure/gonioreflectometer.hpp"
#include "framework/math/error.hpp"

#include <cmath>

namespace glint {

// The directions of an angle from N to H, from H to L, and of L's turn about H; radians.
inline Incidence<double> incidence_of_half(double theta_half, double theta_difference,
                                           double phi_difference) {
    const double up = std::cos(theta_half) * std::cos(theta_difference);
    const double aside =
        std::sin(theta_half) * std::sin(theta_difference) * std::cos(phi_difference);
    return {up - aside, up + aside, std::cos(2 * theta_difference)};
}

// The BRDF at the middle of every cell; -1 where light or viewer would be below the horizon.
template <class Brdf>
MerlBrdf capture(const Brdf& brdf, int half, int difference, int azimuth) {
    MerlBrdf m{half, difference, azimuth, {}};
    const double right = std::numbers::pi / 2;
    for (int i = 0; i < half; ++i) {
        const double root = (i + 0.5) / half;
        for (int j = 0; j < difference; ++j) {
            for (int k = 0; k < azimuth; ++k) {
                const auto g =
                    incidence_of_half(root * root * right, (j + 0.5) / difference * right,
                                      (k + 0.5) / azimuth * 2 * right);
                m.values.push_back(std::min(g.NL, g.NV) > 0 ? brdf(g) : Rgb<double>(-1));
            }
        }
    }
    return m;
}

// What a viewer sees of constant light from everywhere, in the mean over the viewer's directions.
template <class Brdf>
Rgb<double> mean_albedo(const Brdf& brdf) {
    static const Quadrature rule = gauss_legendre(4);
    return integrate(rule, 0, 1,
                     [&](double c) { return directional_albedo(brdf, c, Fixed::view) * (2 * c); });
}

namespace capture_detail {

inline bool measured(const Rgb<double>& value) {
    return value.r >= 0 && value.g >= 0 && value.b >= 0;
}

// The mean of what was measured at two places that should be alike; else negative.
inline Rgb<double> merged(const Rgb<double>& a, const Rgb<double>& b) {
    return !measured(a) ? b : !measured(b) ? a : (a + b) * 0.5;
}

// Gives each cell of a column that has no value the one before it, or else the first one after.
inline void fill(std::vector<Rgb<double>>& column) {
    Rgb<double> last(0);
    for (auto at = column.rbegin(); at != column.rend(); ++at) {
        last = measured(*at) ? *at : last;  // ends as the first
    }
    for (Rgb<double>& value : column) {
        value = last = measured(value) ? value : last;
    }
}

}  // namespace capture_detail

// A table to look up. What was not measured, as below the horizon, gets the value of the nearest
// smaller theta_difference that was. Error where the count of phi_difference is odd.
inline std::shared_ptr<const BrdfTable> table_of(const MerlBrdf& m) {
    using namespace capture_detail;
    if (m.azimuth % 2 != 0) {
        throw Error("a BRDF table needs an even number of phi_difference, not " +
                    std::to_string(m.azimuth));
    }
    auto table = std::make_shared<BrdfTable>(
        BrdfTable{m.half, m.difference, m.azimuth / 2, {}, Rgb<float>(0.0F)});
    const auto at = [&](int i, int j, int k) {
        return static_cast<std::size_t>((i * m.difference + j) * m.azimuth + k);
    };
    table->rgb.resize(m.values.size() / 2 * 3);
    std::vector<Rgb<double>> column(static_cast<std::size_t>(m.difference));
    for (int i = 0; i < m.half; ++i) {
        for (int k = 0; k < table->azimuth; ++k) {
            for (int j = 0; j < m.difference; ++j) {
                column[static_cast<std::size_t>(j)] =
                    merged(m.values[at(i, j, k)], m.values[at(i, j, m.azimuth - 1 - k)]);
            }
            fill(column);
            for (int j = 0; j < m.difference; ++j) {
                const auto cell =
                    static_cast<std::size_t>((i * m.difference + j) * table->azimuth + k);
                for (int c = 0; c < 3; ++c) {
                    table->rgb[3 * cell + static_cast<std::size_t>(c)] =
                        static_cast<float>(column[static_cast<std::size_t>(j)][c]);
                }
            }
        }
    }
    table->ambient_albedo = Rgb<float>(mean_albedo(MeasuredBrdf{table}));
    return table;
}

}  // namespace glint
