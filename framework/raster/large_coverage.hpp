// Coverage of triangles of any size: blocks are sorted, some columns at a time, into those outside,
// those covered entirely and those that an edge crosses; then drawn kind by kind, with no branch to
// mispredict.
#pragma once

#include "framework/raster/block.hpp"
#include "framework/raster/tile_setup.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace glint {

// By block of a tile: its first column, or row. Looked up, for turning integers into floats and
// those into registers takes longer than a block's depths.
template <bool rows>
inline constexpr auto first_pixels = [] {
    std::array<float, static_cast<std::size_t>(tile_blocks * tile_blocks)> all{};
    for (std::size_t block = 0; block < all.size(); ++block) {
        all[block] =
            static_cast<float>(block_size * (rows ? block / tile_blocks : block % tile_blocks));
    }
    return all;
}();

// One triangle over the samples of one kind (one offset) of a tile. Blocks and pixels count from
// the first block that the triangle may cover.
template <int N>
class LargeCoverage {
    using T = typename Lanes<N>::Float;
    using I = typename Lanes<N>::Int;
    using M = typename Lanes<N>::Mask;
    static constexpr int parts = block_parts<N>;

  public:
    LargeCoverage(const TileSetup<N>& t, const SampleSetup<N>& sample, std::size_t lane)
        : first_column_(t.x0[lane] / block_size),
          first_row_(t.y0[lane] / block_size),
          columns_(t.x1[lane] / block_size - first_column_ + 1),
          rows_(t.y1[lane] / block_size - first_row_ + 1),
          plane_{t.depth.z[lane], t.depth.dzdx[lane], t.depth.dzdy[lane], t.depth.low[lane],
                 t.depth.high[lane]} {
        for (std::size_t i = 0; i < 3; ++i) {
            a_[i] = t.a[i][lane];
            b_[i] = t.b[i][lane];
            e_[i] = sample.e[i][lane];
        }
        for (unsigned p = 0; p < parts; ++p) {
            const I column = load<I>(&block_columns<std::int32_t>[p * N]);
            const I row = load<I>(&block_rows<std::int32_t>[p * N]);
            for (std::size_t i = 0; i < 3; ++i) {
                within_[i][p] = I(e_[i]) + I(a_[i]) * column + I(b_[i]) * row;
            }
            x_[p] = T(sample.x[lane]) + to_float(column);
            y_[p] = T(sample.y[lane]) + to_float(row);
        }
    }

    // depth and owner: of the tile.
    void draw(float* depth, std::int32_t* owner, std::int32_t triangle) const {
        Blocks full;
        Blocks partial;
        for (std::int32_t column = 0; column < columns_; column += N) {
            list_columns(column, full, partial);
        }
        const std::ptrdiff_t first = (first_row_ * tile_blocks + first_column_) * block_pixels;
        for (std::int32_t i = 0; i < full.count; ++i) {
            draw_block<true>(full.place[i], depth + first, owner + first, triangle);
        }
        for (std::int32_t i = 0; i < partial.count; ++i) {
            draw_block<false>(partial.place[i], depth + first, owner + first, triangle);
        }
    }

  private:
    // Blocks of a tile, as tile_blocks times the row plus the column.
    struct Blocks {
        std::int32_t count = 0;
        std::int32_t place[tile_blocks * tile_blocks + N];  // what sticks out is overwritten

        void add(std::uint32_t lanes, const I& places) {
            count += store_lanes(&place[count], lanes, places);
        }
    };

    // Of N columns of blocks: those that the triangle covers entirely, and those that an edge
    // crosses.
    void list_columns(std::int32_t first, Blocks& full, Blocks& partial) const {
        const I column = iota<I>() + I(first);
        const M beyond = column >= I(columns_);
        I place = column;
        I least[3];  // E in a block, a row of blocks at a time
        I most[3];
        for (std::size_t i = 0; i < 3; ++i) {
            const std::int32_t a = a_[i] * (block_size - 1);
            const std::int32_t b = b_[i] * (block_size - 1);
            const I e = I(e_[i]) + I(a_[i] * block_size) * column;
            least[i] = e + I(std::min(a, 0) + std::min(b, 0));
            most[i] = e + I(std::max(a, 0) + std::max(b, 0));
        }
        for (std::int32_t row = 0; row < rows_; ++row) {
            const M outside = beyond | ((most[0] | most[1] | most[2]) < I(0));
            const M crossed = (least[0] | least[1] | least[2]) < I(0);
            full.add(lane_bits(!(outside | crossed)), place);
            partial.add(lane_bits(crossed & !outside), place);
            for (std::size_t i = 0; i < 3; ++i) {
                least[i] += I(b_[i] * block_size);
                most[i] += I(b_[i] * block_size);
            }
            place += I(tile_blocks);
        }
    }

    template <bool full>
    void draw_block(std::int32_t place, float* depth, std::int32_t* owner,
                    std::int32_t triangle) const {
        const auto block = static_cast<std::uint32_t>(place);
        const T block_x(first_pixels<false>[block]);
        const T block_y(first_pixels<true>[block]);
        for (int p = 0; p < parts; ++p) {
            M covered = true;
            if constexpr (!full) {
                const auto column = static_cast<std::int32_t>(block % tile_blocks * block_size);
                const auto row = static_cast<std::int32_t>(block / tile_blocks * block_size);
                I signs(0);
                for (std::size_t i = 0; i < 3; ++i) {
                    signs = signs | (within_[i][p] + I(a_[i] * column + b_[i] * row));
                }
                covered = signs >= I(0);
            }
            const std::int32_t at = place * block_pixels + p * N;
            put_nearer<N>(covered, plane_.at(x_[p] + block_x, y_[p] + block_y), depth + at,
                          owner + at, triangle);
        }
    }

    std::int32_t first_column_, first_row_, columns_, rows_;  // blocks
    std::int32_t e_[3], a_[3], b_[3];
    I within_[3][parts];  // E of the first block's pixels
    T x_[parts], y_[parts];
    BlockDepth<N> plane_;
};

}  // namespace glint
