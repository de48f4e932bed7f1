// From BRDFs to tables and back: the gonioreflectometer writes down what it measures.
#pragma once

#include "lessons/07_measured_brdf/measured_brdf.hpp"
#include "framework/app/merl.hpp"
#include "framework/measure/gonioreflectometer.hpp"
#include "framework/math/error.hpp"

#include <algorithm>
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
    const auto first = std::find_if(column.begin(), column.end(), measured);
    Rgb<double> last = first == column.end() ? Rgb<double>(0) : *first;
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
    const auto rows = static_cast<std::size_t>(m.difference);
    const auto turns = static_cast<std::size_t>(m.azimuth);
    table->rgb.resize(m.values.size() / 2 * 3);
    std::vector<Rgb<double>> column(rows);
    for (std::size_t i = 0; i < static_cast<std::size_t>(m.half); ++i) {
        for (std::size_t k = 0; k < turns / 2; ++k) {
            for (std::size_t j = 0; j < rows; ++j) {
                const std::size_t row = (i * rows + j) * turns;
                column[j] = merged(m.values[row + k], m.values[row + turns - 1 - k]);
            }
            fill(column);
            for (std::size_t j = 0; j < rows; ++j) {
                const std::size_t cell = (i * rows + j) * (turns / 2) + k;
                table->rgb[3 * cell] = static_cast<float>(column[j].r);
                table->rgb[3 * cell + 1] = static_cast<float>(column[j].g);
                table->rgb[3 * cell + 2] = static_cast<float>(column[j].b);
            }
        }
    }
    table->ambient_albedo = Rgb<float>(mean_albedo(MeasuredBrdf{table}));
    return table;
}

}  // namespace glint
