// Triangle set-up: exact edge functions under the top-left rule, and the depth plane.
#pragma once

#include "framework/raster/pipeline.hpp"

#include <algorithm>
#include <array>

namespace glint {

// E(x, y) = a x + b y + c over window positions in 1/256 pixel, positive inside, with one taken off
// where the edge is neither top nor left: a sample is covered where E >= 0 for all three edges.
// (Top-left rule: Direct3D 11 functional specification, 3.4.2.1.) Exact: |a|, |b| <= 2^23 and
// |c| <= 2^47 within the guard band.
struct Edge {
    std::int64_t a, b, c;
    bool inclusive;  // top or left: samples on the edge are covered

    std::int64_t at(std::int64_t x, std::int64_t y) const { return a * x + b * y + c; }
};

struct Edges {
    std::array<Edge, 3> edge;  // edge i is opposite to vertex i
    std::int64_t double_area;  // signed, in 1/65536 pixel^2; negative for front faces; 0: no area
};

// For positive double_area the interior is on the right of v0 -> v1 -> v2 as seen on the screen
// (y down); otherwise all three edges are turned round, so that the interior is positive always.
inline Edges edges_of(const ScreenVertex (&v)[3]) {
    Edges e{};
    const std::int64_t x[3] = {v[0].x, v[1].x, v[2].x};
    const std::int64_t y[3] = {v[0].y, v[1].y, v[2].y};
    e.double_area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
    const std::int64_t turn = e.double_area < 0 ? -1 : 1;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t from = (i + 1) % 3;
        const std::size_t to = (i + 2) % 3;
        const std::int64_t a = turn * (y[from] - y[to]);
        const std::int64_t b = turn * (x[to] - x[from]);
        const bool inclusive = a > 0 || (a == 0 && b > 0);
        e.edge[i] = {a, b, -(a * x[from] + b * y[from]) - (inclusive ? 0 : 1), inclusive};
    }
    return e;
}

inline bool culled(const Edges& e, Cull cull) {
    return e.double_area == 0 || (cull == Cull::back && e.double_area > 0);
}

// Depth as a plane over the window, anchored at the farthest vertex: there reversed z is finest,
// and rounding errors grow with the distance from the anchor. Limited to the depths of the
// vertices, so that a sliver's steep plane cannot leave them. T is float or lanes; every
// rasterizer evaluates this text, without contraction, and so gets the same bits.
template <class T>
struct DepthPlane {
    T x, y;  // anchor, pixels
    T z, dzdx, dzdy;
    T low, high;

    T at(T px, T py) const {  // window position in pixels
        return min(max(z + (dzdx * (px - x) + dzdy * (py - y)), low), high);
    }
};

// Vertices as 24.8 integers, double_area as float (rounded from the exact integer, not zero).
template <class T, class I>
DepthPlane<T> depth_plane(const I (&x)[3], const I (&y)[3], const T (&z)[3], T double_area) {
    const T dx1 = to_float(x[1] - x[0]);
    const T dy1 = to_float(y[1] - y[0]);
    const T dx2 = to_float(x[2] - x[0]);
    const T dy2 = to_float(y[2] - y[0]);
    const T dz1 = z[1] - z[0];
    const T dz2 = z[2] - z[0];
    const T scale = T(static_cast<float>(subpixel_one)) / double_area;
    const T pixel(1.0F / static_cast<float>(subpixel_one));
    DepthPlane<T> p;
    p.dzdx = (dz1 * dy2 - dz2 * dy1) * scale;
    p.dzdy = (dz2 * dx1 - dz1 * dx2) * scale;
    p.low = min(min(z[0], z[1]), z[2]);
    p.high = max(max(z[0], z[1]), z[2]);
    const auto second = z[1] == p.low;
    const auto first = z[0] == p.low;
    p.z = p.low;
    p.x = select(first, to_float(x[0]), select(second, to_float(x[1]), to_float(x[2]))) * pixel;
    p.y = select(first, to_float(y[0]), select(second, to_float(y[1]), to_float(y[2]))) * pixel;
    return p;
}

inline DepthPlane<float> depth_plane(const ScreenVertex (&v)[3], std::int64_t double_area) {
    const std::int32_t x[3] = {v[0].x, v[1].x, v[2].x};
    const std::int32_t y[3] = {v[0].y, v[1].y, v[2].y};
    const float z[3] = {v[0].z, v[1].z, v[2].z};
    return depth_plane(x, y, z, static_cast<float>(double_area));
}

}  // namespace glint
