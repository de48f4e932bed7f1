// What every row of the atlas of failures (docs/stability.md) does: hold the naive form to its
// failure and Glint's to its bound, and keep both numbers for the atlas.
#pragma once

#include "framework/raster/pipeline.hpp"
#include "framework/image/image.hpp"
#include "tests/unit/lessons/lane_value.hpp"

#include <doctest/doctest.h>

#include <functional>
#include <limits>
#include <string>

namespace glint::stability {

// How far off two ways to compute the same thing are, by the row's own measure; NaN is the worst.
struct Errors {
    double naive = 0;
    double glint = 0;
};

inline constexpr double infinite = std::numeric_limits<double>::infinity();
inline double or_infinite(double error) {
    if (std::isnan(error)) {
        return infinite;
    }
    return error;
}

// Larger errors replace smaller ones.
inline void add(Errors& worst, const Errors& e) {
    worst.naive = or_infinite(worst.naive) >= or_infinite(e.naive) ? worst.naive : e.naive;
    worst.glint = or_infinite(worst.glint) >= or_infinite(e.glint) ? worst.glint : e.glint;
}

// What f.operator()<T>() says in float and in every width of lanes: the naive form's least error,
// for it is to fail in all of them, and Glint's largest.
template <class F>
Errors in_floats(F&& f) {
    Errors least{infinite, 0};
    const auto join = [&](const Errors& e) {
        const double naive = or_infinite(e.naive) <= least.naive ? e.naive : least.naive;
        add(least, e);
        least.naive = naive;
    };
    join(f.template operator()<float>());
    join(f.template operator()<Float4>());
    join(f.template operator()<Float8>());
    join(f.template operator()<Float16>());
    return least;
}

// The same, and Glint's in double, where the naive form may do.
template <class F>
Errors in_all_numbers(F&& f) {
    Errors e = in_floats(f);
    add(e, {0, f.template operator()<double>().glint});
    return e;
}

// Draws in T: the tiles in as many lanes; the scanlines, which have none, for double.
template <Real T>
Settings settings_of() {
    if constexpr (std::same_as<T, double>) {
        return {.rasterizer = Rasterizer::scanline};
    } else {
        return {.lanes = lanes_of<T>};
    }
}

// The naive form is off by at least fails, Glint by at most bound. Where GLINT_ATLAS names a
// folder, a line of its file rows says so: name, naive, glint, bound.
void row(const Errors& e, double fails, double bound);

// The failure and the cure side by side, magnified: picture NAME.png in that folder.
using Shade = std::function<Rgb<float>(int x, int y)>;
void picture(const std::string& name, int width, int height, int magnify, const Shade& naive,
             const Shade& glint);

}  // namespace glint::stability
