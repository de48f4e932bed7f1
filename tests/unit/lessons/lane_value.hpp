// What lessons' tests share: numbers out of any number type, and angles in degrees.
#pragma once

#include "tests/unit/math/lane_types.hpp"

#include <cmath>
#include <numbers>

namespace glint {

inline constexpr double pi = std::numbers::pi;

// The last lane of x.
template <class T>
double value(const T& x) {
    if constexpr (std::same_as<T, double>) {
        return x;
    } else {
        return double{lane(x, lanes_of<T> - 1)};
    }
}

inline double cos_of_degrees(double degrees) {
    return degrees == 90 ? 0.0 : std::cos(degrees * pi / 180);
}

}  // namespace glint
