// Triangle set-up for one tile, N triangles at a time, in 32-bit integers.
//
// E(x, y) at a sample is a 64-bit number, but the tile asks only whether it is >= 0. From one pixel
// to the next E changes by 256 a or 256 b, so floor(E / 256) changes by a or b exactly and has the
// same sign: that fits 32 bits wherever the edge crosses the tile. Edges that do not cross it are
// decided once, with 64 bits.
#pragma once

#include "framework/raster/lane_edges.hpp"
#include "framework/raster/setup.hpp"
#include "framework/raster/tile.hpp"

namespace glint {

template <int N>
struct alignas(4 * N) TileSetup {
    using Ints = std::array<std::int32_t, N>;
    using Floats = std::array<float, N>;
    std::array<Ints, 3> whole, rest;  // E at the centre of the tile's first pixel: 256 whole + rest
    std::array<Ints, 3> a, b;
    Ints x0, y0, x1, y1;  // the pixels in the tile that it may cover; x0 > x1: none
    DepthPlane<Floats> depth;
};

// The same seen from one sample of every pixel, beginning at the first block that the triangle may
// cover.
template <int N>
struct alignas(4 * N) SampleSetup {
    std::array<std::array<std::int32_t, N>, 3> e;  // floor(E / 256) at the first pixel's sample
    std::array<float, N> x, y;                     // that sample, pixels from the depth's anchor
};

template <int N>
void place_sample(const TileSetup<N>& t, const TileBuffer& tile, SampleOffset offset,
                  SampleSetup<N>& out) {
    using T = typename Lanes<N>::Float;
    using I = typename Lanes<N>::Int;
    const I column = load<I>(t.x0.data()) & I(-block_size);
    const I row = load<I>(t.y0.data()) & I(-block_size);
    for (std::size_t i = 0; i < 3; ++i) {
        const I a = load<I>(t.a[i].data());
        const I b = load<I>(t.b[i].data());
        // floor((256 whole + rest + a x + b y) / 256), where a x alone may pass 32 bits.
        const I low(subpixel_one - 1);
        const I x(offset.x);
        const I y(offset.y);
        const I rest = load<I>(t.rest[i].data()) + (a & low) * x + (b & low) * y;
        const I e = load<I>(t.whole[i].data()) + (a >> subpixel_bits) * x +
                    (b >> subpixel_bits) * y + (rest >> subpixel_bits);
        store(out.e[i].data(), e + a * column + b * row);
    }
    // Differences of window positions are exact in float.
    const float to_pixel = 1.0F / static_cast<float>(subpixel_one);
    const T x(static_cast<float>(tile.x) + 0.5F + static_cast<float>(offset.x) * to_pixel);
    const T y(static_cast<float>(tile.y) + 0.5F + static_cast<float>(offset.y) * to_pixel);
    store(out.x.data(), x - load<T>(t.depth.x.data()) + to_float(column));
    store(out.y.data(), y - load<T>(t.depth.y.data()) + to_float(row));
}

// For triangles of less than 64 pixels in width and height: then 32 bits hold E itself.
template <int N>
void set_up_small(const typename Lanes<N>::Int (&x)[3], const typename Lanes<N>::Int (&y)[3],
                  const typename Lanes<N>::Float (&z)[3], const TileBuffer& tile, Cull cull,
                  const OffsetRange& range, TileSetup<N>& out) {
    using T = typename Lanes<N>::Float;
    using I = typename Lanes<N>::Int;
    using M = typename Lanes<N>::Mask;
    const I area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
    const M drawn = (area != I(0)) & (M(cull == Cull::none) | (area < I(0)));
    const M turned = area < I(0);
    I left[3];
    I top[3];
    for (int i = 0; i < 3; ++i) {
        left[i] = x[i] - I(tile.x * subpixel_one);
        top[i] = y[i] - I(tile.y * subpixel_one);
    }
    const I first_x(tile.x * subpixel_one + subpixel_one / 2);
    const I first_y(tile.y * subpixel_one + subpixel_one / 2);
    for (std::size_t i = 0; i < 3; ++i) {
        const LaneEdge<N> edge = lane_edge<N>(x, y, turned, i, first_x, first_y);
        store(out.whole[i].data(), edge.e >> subpixel_bits);
        store(out.rest[i].data(), edge.e & I(subpixel_one - 1));
        store(out.a[i].data(), edge.a);
        store(out.b[i].data(), edge.b);
    }
    const auto smallest = [](const I(&v)[3]) { return min(min(v[0], v[1]), v[2]); };
    const auto largest = [](const I(&v)[3]) { return max(max(v[0], v[1]), v[2]); };
    store(out.x0.data(), select(drawn, first_pixel(smallest(left), range.high.x), I(tile_size)));
    store(out.y0.data(), first_pixel(smallest(top), range.high.y));
    store(out.x1.data(), last_pixel(largest(left), range.low.x, tile_size - 1));
    store(out.y1.data(), last_pixel(largest(top), range.low.y, tile_size - 1));
    const DepthPlane<T> p = depth_plane(x, y, z, to_float(area));
    store(out.depth.x.data(), p.x);
    store(out.depth.y.data(), p.y);
    store(out.depth.z.data(), p.z);
    store(out.depth.dzdx.data(), p.dzdx);
    store(out.depth.dzdy.data(), p.dzdy);
    store(out.depth.low.data(), p.low);
    store(out.depth.high.data(), p.high);
}

// For one triangle of any size, into lane number lane.
template <int N>
void set_up_any(const ScreenTriangle& t, const TileBuffer& tile, Cull cull,
                const OffsetRange& range, std::size_t lane, TileSetup<N>& out) {
    const Edges edges = edges_of(t.v);
    out.x0[lane] = tile_size;  // nothing covered, as long as no edge says otherwise
    out.x1[lane] = 0;
    if (culled(edges, cull)) {
        return;
    }
    const std::int32_t origin_x = tile.x * subpixel_one;
    const std::int32_t origin_y = tile.y * subpixel_one;
    for (std::size_t i = 0; i < 3; ++i) {
        const Edge& edge = edges.edge[i];
        const std::int64_t e = edge.at(origin_x + subpixel_one / 2, origin_y + subpixel_one / 2);
        const std::int64_t span = (tile_size - 1) * subpixel_one;
        const std::int64_t about_centre =
            (std::abs(edge.a) + std::abs(edge.b)) * (subpixel_one / 2);
        const std::int64_t low = e + std::min<std::int64_t>(edge.a, 0) * span +
                                 std::min<std::int64_t>(edge.b, 0) * span - about_centre;
        const std::int64_t high = e + std::max<std::int64_t>(edge.a, 0) * span +
                                  std::max<std::int64_t>(edge.b, 0) * span + about_centre;
        if (high < 0) {
            return;  // the whole tile is outside this edge
        }
        const bool crosses = low < 0;
        out.whole[i][lane] = crosses ? static_cast<std::int32_t>(e >> subpixel_bits) : 0;
        out.rest[i][lane] = crosses ? static_cast<std::int32_t>(e & (subpixel_one - 1)) : 0;
        out.a[i][lane] = crosses ? static_cast<std::int32_t>(edge.a) : 0;
        out.b[i][lane] = crosses ? static_cast<std::int32_t>(edge.b) : 0;
    }
    const auto [left, right] = std::minmax({t.v[0].x, t.v[1].x, t.v[2].x});
    const auto [top, bottom] = std::minmax({t.v[0].y, t.v[1].y, t.v[2].y});
    out.x0[lane] = first_pixel(left - origin_x, range.high.x);
    out.y0[lane] = first_pixel(top - origin_y, range.high.y);
    out.x1[lane] = last_pixel(right - origin_x, range.low.x, tile_size - 1);
    out.y1[lane] = last_pixel(bottom - origin_y, range.low.y, tile_size - 1);
    const DepthPlane<float> p = depth_plane(t.v, edges.double_area);
    out.depth.x[lane] = p.x;
    out.depth.y[lane] = p.y;
    out.depth.z[lane] = p.z;
    out.depth.dzdx[lane] = p.dzdx;
    out.depth.dzdy[lane] = p.dzdy;
    out.depth.low[lane] = p.low;
    out.depth.high[lane] = p.high;
}

}  // namespace glint
