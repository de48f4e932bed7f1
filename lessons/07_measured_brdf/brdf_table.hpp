// The memory of lesson 7's BRDFs: cells in three dimensions, and a place between them.
#pragma once

#include "framework/math/vec.hpp"

#include <vector>

namespace glint {

// Values in 1/sr at the middles of half * difference * azimuth cells, each axis 0..1.
struct BrdfTable {
    int half, difference, azimuth;
    std::vector<float> rgb;     // theta_half slowest, colours fastest
    Rgb<float> ambient_albedo;  // mean over the viewer's directions

    // The value of a cell; each lane may ask for its own.
    template <Real T>
    Rgb<T> at(const IntOf<T>& i, const IntOf<T>& j, const IntOf<T>& k) const {
        using I = IntOf<T>;
        const I first = ((i * I(difference) + j) * I(azimuth) + k) * I(3);
        return {T(gather(rgb.data(), first)), T(gather(rgb.data() + 1, first)),
                T(gather(rgb.data() + 2, first))};
    }
};

// The cells whose middles are on either side of a place 0..1 on an axis, and how far between them
// it is. Before the first middle and after the last it is on them.
template <Real T>
struct Neighbours {
    IntOf<T> low, high;
    T share;
    Neighbours(const T& place, int cells) {
        const T last(static_cast<float>(cells - 1));
        const T x = clamp(place * (last + 1.0F) - 0.5F, T(0.0F), last);
        low = truncate_to_int(x);
        high = min(low + IntOf<T>(1), IntOf<T>(cells - 1));
        share = x - T(low);
    }
};

}  // namespace glint
