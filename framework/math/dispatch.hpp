// From a number of lanes chosen at run time to one known at compile time.
#pragma once

#include "framework/math/error.hpp"
#include "framework/math/lanes.hpp"

#include <string>
#include <utility>

namespace glint {

// True for 1, 4, 8 and 16 as far as this build has them.
inline bool has_lanes(int lanes) {
    return lanes == 1 || ((lanes == 4 || lanes == 8 || lanes == 16) && lanes <= max_lanes);
}

// Calls f.operator()<N>() with N = lanes; Error where this build has no such lanes.
template <class F>
decltype(auto) with_lanes(int lanes, F&& f) {
    if (!has_lanes(lanes)) {
        throw Error("lanes: " + std::to_string(lanes) +
                    " is not to be had, this build has 1, 4, ... " + std::to_string(max_lanes));
    }
    if constexpr (max_lanes >= 16) {
        if (lanes == 16) {
            return std::forward<F>(f).template operator()<16>();
        }
    }
    if constexpr (max_lanes >= 8) {
        if (lanes == 8) {
            return std::forward<F>(f).template operator()<8>();
        }
    }
    if (lanes == 4) {
        return std::forward<F>(f).template operator()<4>();
    }
    return std::forward<F>(f).template operator()<1>();
}

}  // namespace glint
