// Coverage of triangles of any size: blocks are sorted, a row at a time, into those outside, those
// covered entirely and those that an edge crosses; then drawn kind by kind, with no branch to
// mispredict.
#pragma once

#include "framework/raster/block.hpp"
#include "framework/raster/tile_setup.hpp"

#include <algorithm>
#include <bit>

namespace glint {

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
        for (std::int32_t row = 0; row < rows_; ++row) {
            list_row(row, full, partial);
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

    // Of a row of blocks: those that the triangle covers entirely, and those that an edge crosses.
    void list_row(std::int32_t row, Blocks& full, Blocks& partial) const {
        for (int first = 0; first < columns_; first += N) {
            const I column = iota<I>() + I(first);
            M outside = column >= I(columns_);
            M crossed = false;
            for (std::size_t i = 0; i < 3; ++i) {
                const I e = I(e_[i] + b_[i] * block_size * row) + I(a_[i] * block_size) * column;
                const std::int32_t a = a_[i] * (block_size - 1);
                const std::int32_t b = b_[i] * (block_size - 1);
                outside = outside | (e + I(std::max(a, 0) + std::max(b, 0)) < I(0));
                crossed = crossed | (e + I(std::min(a, 0) + std::min(b, 0)) < I(0));
            }
            const I place = column + I(row * tile_blocks);
            full.add(lane_bits(!(outside | crossed)), place);
            partial.add(lane_bits(crossed & !outside), place);
        }
    }

    template <bool full>
    void draw_block(std::int32_t place, float* depth, std::int32_t* owner,
                    std::int32_t triangle) const {
        const std::int32_t column = place % tile_blocks;
        const std::int32_t row = place / tile_blocks;
        const T block_x(static_cast<float>(column * block_size));
        const T block_y(static_cast<float>(row * block_size));
        for (int p = 0; p < parts; ++p) {
            M covered = true;
            if constexpr (!full) {
                I signs(0);
                for (std::size_t i = 0; i < 3; ++i) {
                    signs =
                        signs | (within_[i][p] + I((a_[i] * column + b_[i] * row) * block_size));
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
