// Numbers as colours, for pictures of quantities.
#pragma once

#include "framework/image/colour.hpp"
#include "framework/math/polynomial.hpp"

namespace glint {

// 0 is dark violet, then blue, green, and 1 pale yellow; equal steps of x look like equal steps of
// colour. Below 0 counts as 0. Above 1, by more than rounding (1e-4), and NaN: magenta, a colour
// that the map has nowhere. Linear RGB; the curve is a Bezier of degree 4 through Oklab.
template <Real T>
Rgb<T> false_colour(T x) {
    const T t = clamp(x, T(0.0F), T(1.0F));
    const Rgb<T> map = rgb_from_oklab(
        Vec3<T>(polynomial(t, 0.2F, 0.73F), polynomial(t, 0.088F, 0.052F, -1.956F, 2.912F, -1.135F),
                polynomial(t, -0.046F, -0.532F, 1.122F, -0.048F, -0.341F)));
    const MaskOf<T> fits = x <= T(1.0001F);
    return select(fits, max(map, Rgb<T>(T(0.0F))), Rgb<T>(T(1.0F), T(0.0F), T(0.5F)));
}

}  // namespace glint
