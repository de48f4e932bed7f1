// Coverage of triangles that reach over 4x4 blocks at most: their blocks are listed first, of N
// triangles; then block by block is drawn, with no branch to mispredict.
//
// The edges are those of large triangles, as floats: below 64 pixels in width and height
// |floor(E / 256)| < 2^24, so every float here is a whole number, and exact.
#pragma once

#include "framework/raster/block.hpp"
#include "framework/raster/tile_setup.hpp"

namespace glint {

namespace small_coverage_detail {

inline constexpr int most_blocks = 4;  // in a row or column
inline constexpr int places = most_blocks * most_blocks;

// By place, 4 row + column: the columns and rows of its pixels.
template <bool rows>
inline constexpr auto pixels_of_place = [] {
    std::array<std::array<float, block_pixels>, places> all{};
    for (std::size_t place = 0; place < places; ++place) {
        const std::size_t first = block_size * (rows ? place / most_blocks : place % most_blocks);
        for (std::size_t i = 0; i < block_pixels; ++i) {
            all[place][i] =
                static_cast<float>(first) + (rows ? block_rows<float>[i] : block_columns<float>[i]);
        }
    }
    return all;
}();

}  // namespace small_coverage_detail

template <int N>
class SmallCoverage {
    using T = typename Lanes<N>::Float;
    using I = typename Lanes<N>::Int;
    using M = typename Lanes<N>::Mask;
    using Floats = std::array<float, N>;
    using Ints = std::array<std::int32_t, N>;
    static constexpr int parts = block_parts<N>;
    static constexpr int most_blocks = small_coverage_detail::most_blocks;
    static constexpr int places = small_coverage_detail::places;

  public:
    // Lanes whose triangles reach over few enough blocks.
    static std::uint32_t fitting(const TileSetup<N>& t) {
        const M columns = blocks_behind_first(t.x0, t.x1) < I(most_blocks);
        const M rows = blocks_behind_first(t.y0, t.y1) < I(most_blocks);
        return lane_bits(columns & rows);
    }

    // Seen from one sample of every pixel. The triangle of lane i is number `triangle` + i.
    SmallCoverage(const TileSetup<N>& t, const SampleSetup<N>& sample, std::int32_t triangle)
        : depth_(t.depth), x_(sample.x), y_(sample.y) {
        const I column = load<I>(t.x0.data()) & I(-block_size);
        const I row = load<I>(t.y0.data()) & I(-block_size);
        store(first_.data(), column * I(block_size) + row * I(tile_size));
        store(number_.data(), iota<I>() + I(triangle));
        T reach[3];  // E at most in a block
        T right[3];  // and from there to the next
        T down[3];
        for (std::size_t i = 0; i < 3; ++i) {
            const T a = to_float(load<I>(t.a[i].data()));
            const T b = to_float(load<I>(t.b[i].data()));
            const T e = to_float(load<I>(sample.e[i].data()));
            store(a_[i].data(), a);
            store(b_[i].data(), b);
            store(e_[i].data(), e);
            reach[i] = e + T(block_size - 1) * (max(a, T(0.0F)) + max(b, T(0.0F)));
            right[i] = T(block_size) * a;
            down[i] = T(block_size) * b;
        }
        find_blocks(reach, right, down, load<I>(t.x1.data()) - column, load<I>(t.y1.data()) - row);
    }

    // Draws the triangles of these lanes, in order; depth and owner are the tile's.
    void draw(std::uint32_t lanes, float* depth, std::int32_t* owner) {
        std::int32_t count = 0;
        for (; lanes != 0; lanes &= lanes - 1) {
            count += list_blocks(std::countr_zero(lanes), &blocks_[static_cast<unsigned>(count)]);
        }
        for (std::int32_t i = 0; i < count; ++i) {
            const auto block = static_cast<unsigned>(blocks_[static_cast<unsigned>(i)]);
            draw_block(block / places, block % places, depth, owner);
        }
    }

  private:
    static I blocks_behind_first(const Ints& first, const Ints& last) {
        return (load<I>(last.data()) >> block_bits) - (load<I>(first.data()) >> block_bits);
    }

    // Notes the places where a triangle may cover something, by triangle, a bit each.
    void find_blocks(T (&reach)[3], const T (&right)[3], const T (&down)[3], I width, I height) {
        I touched(0);
        for (int row = 0; row < most_blocks; ++row) {
            const M in_row = height >= I(row * block_size);
            if (!any(in_row)) {
                break;
            }
            T e[3] = {reach[0], reach[1], reach[2]};
            for (int column = 0; column < most_blocks; ++column) {
                const M here = in_row & (width >= I(column * block_size));
                if (!any(here)) {
                    break;
                }
                const I bit(1 << (row * most_blocks + column));
                touched = touched | select(here & no_sign(e[0], e[1], e[2]), bit, I(0));
                for (std::size_t i = 0; i < 3; ++i) {
                    e[i] += right[i];
                }
            }
            for (std::size_t i = 0; i < 3; ++i) {
                reach[i] += down[i];
            }
        }
        store(touched_.data(), touched);
    }

    // The triangle's blocks, as 16 lane + place; returns how many there are.
    int list_blocks(int lane, std::int32_t* out) const {
        const auto touched = static_cast<std::uint32_t>(touched_[static_cast<unsigned>(lane)]);
        int count = 0;
        for (int first = 0; first < places; first += N) {
            count += store_lanes(out + count, touched >> first & ((1U << N) - 1),
                                 iota<I>() + I(lane * places + first));
        }
        return count;
    }

    // All three are >= 0, for sums that are 0 are +0.
    static M no_sign(T a, T b, T c) { return (bits_of(a) | bits_of(b) | bits_of(c)) >= I(0); }

    T edge(std::size_t i, std::size_t lane, T x, T y) const {
        return fma(T(b_[i][lane]), y, fma(T(a_[i][lane]), x, T(e_[i][lane])));
    }

    void draw_block(std::size_t lane, std::size_t place, float* depth, std::int32_t* owner) const {
        using namespace small_coverage_detail;
        const auto column = static_cast<std::int32_t>(place) % most_blocks;
        const auto row = static_cast<std::int32_t>(place) / most_blocks;
        const std::int32_t at =
            first_[lane] + column * block_pixels + row * tile_blocks * block_pixels;
        const BlockDepth<N> plane{T(depth_.z[lane]), T(depth_.dzdx[lane]), T(depth_.dzdy[lane]),
                                  T(depth_.low[lane]), T(depth_.high[lane])};
        for (unsigned p = 0; p < parts; ++p) {
            const T x = load<T>(&pixels_of_place<false>[place][p * N]);
            const T y = load<T>(&pixels_of_place<true>[place][p * N]);
            const M covered =
                no_sign(edge(0, lane, x, y), edge(1, lane, x, y), edge(2, lane, x, y));
            put_nearer<N>(covered, plane.at(T(x_[lane]) + x, T(y_[lane]) + y),
                          depth + at + static_cast<int>(p) * N,
                          owner + at + static_cast<int>(p) * N, number_[lane]);
        }
    }

    // Positions count from the first pixel of the first block that a triangle may cover.
    const DepthPlane<Floats>& depth_;
    const Floats& x_;  // the first sample, from the depth's anchor
    const Floats& y_;
    alignas(4 * N) std::array<Floats, 3> a_, b_;
    alignas(4 * N) std::array<Floats, 3> e_;  // floor(E / 256) at the first sample
    alignas(4 * N) Ints first_;               // where the first block lies in the tile
    alignas(4 * N) Ints touched_;             // a bit for each place
    alignas(4 * N) Ints number_;
    std::array<std::int32_t, (N + 1) * places> blocks_;  // what sticks out is overwritten
};

}  // namespace glint
