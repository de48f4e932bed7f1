// Stage 3 of the tile rasterizer: depth and owner of every sample of a tile.
#include "framework/raster/lane_vertices.hpp"
#include "framework/raster/tile.hpp"
#include "framework/raster/tile_setup.hpp"
#include "framework/geometry/mesh.hpp"
#include "framework/math/dispatch.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>

namespace glint {
namespace {

constexpr std::int32_t block_columns[block_pixels] = {0, 1, 2, 3, 0, 1, 2, 3,
                                                      0, 1, 2, 3, 0, 1, 2, 3};
constexpr std::int32_t block_rows[block_pixels] = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};

// One triangle over the samples of one kind (one offset) of a tile. Blocks and pixels count from
// the first block that the triangle may cover.
template <int N>
class Coverage {
    using T = typename Lanes<N>::Float;
    using I = typename Lanes<N>::Int;
    using M = typename Lanes<N>::Mask;
    static constexpr int parts = block_pixels / N;  // registers a block

  public:
    Coverage(const TileSetup<N>& t, const SampleSetup<N>& sample, std::size_t lane)
        : first_column_(t.x0[lane] / block_size),
          first_row_(t.y0[lane] / block_size),
          columns_(t.x1[lane] / block_size - first_column_ + 1),
          rows_(t.y1[lane] / block_size - first_row_ + 1),
          dzdx_(t.depth.dzdx[lane]),
          dzdy_(t.depth.dzdy[lane]),
          z_(t.depth.z[lane]),
          low_(t.depth.low[lane]),
          high_(t.depth.high[lane]) {
        for (std::size_t i = 0; i < 3; ++i) {
            a_[i] = t.a[i][lane];
            b_[i] = t.b[i][lane];
            e_[i] = sample.e[i][lane];
        }
        for (int p = 0; p < parts; ++p) {
            const I column = load<I>(block_columns + p * N);
            const I row = load<I>(block_rows + p * N);
            for (std::size_t i = 0; i < 3; ++i) {
                within_[i][p] = I(e_[i]) + I(a_[i]) * column + I(b_[i]) * row;
            }
            x_[p] = T(sample.x[lane]) + to_float(column);
            y_[p] = T(sample.y[lane]) + to_float(row);
        }
    }

    // depth and owner: of the tile.
    void draw(float* depth, std::int32_t* owner, std::int32_t triangle) const {
        const std::ptrdiff_t first = (first_row_ * tile_blocks + first_column_) * block_pixels;
        if (columns_ < 4) {
            draw_narrow(depth + first, owner + first, triangle);
            return;
        }
        for (std::int32_t row = 0; row < rows_; ++row) {
            std::uint32_t touched = 0;
            std::uint32_t full = 0;
            classify_row(row, touched, full);
            for (; touched != 0; touched &= touched - 1) {
                const std::int32_t column = std::countr_zero(touched);
                const std::ptrdiff_t at = first + (row * tile_blocks + column) * block_pixels;
                if ((full >> column & 1U) != 0) {
                    draw_block<true>(column, row, depth + at, owner + at, triangle);
                } else {
                    draw_block<false>(column, row, depth + at, owner + at, triangle);
                }
            }
        }
    }

  private:
    // All blocks, step by step; depth and owner of the first.
    void draw_narrow(float* depth, std::int32_t* owner, std::int32_t triangle) const {
        I step[3];
        for (std::size_t i = 0; i < 3; ++i) {
            step[i] = I(a_[i] * block_size);
        }
        for (std::int32_t row = 0; row < rows_; ++row) {
            for (int p = 0; p < parts; ++p) {
                std::ptrdiff_t at = row * tile_blocks * block_pixels + p * N;
                I e[3];
                for (std::size_t i = 0; i < 3; ++i) {
                    e[i] = within_[i][p] + I(b_[i] * block_size * row);
                }
                T x = x_[p];
                const T y = y_[p] + T(static_cast<float>(row * block_size));
                for (std::int32_t column = 0; column < columns_; ++column, at += block_pixels) {
                    const M inside = (e[0] | e[1] | e[2]) >= I(0);
                    put(inside, x, y, depth + at, owner + at, triangle);
                    for (std::size_t i = 0; i < 3; ++i) {
                        e[i] += step[i];
                    }
                    x += T(static_cast<float>(block_size));
                }
            }
        }
    }

    // Where the triangle is inside and nearer than what is there.
    void put(M inside, T x, T y, float* depth, std::int32_t* owner, std::int32_t triangle) const {
        // DepthPlane::at(), with the sample's position relative to the anchor.
        const T z = min(max(z_ + (dzdx_ * x + dzdy_ * y), low_), high_);
        const T known = load<T>(depth);
        const M wins = inside & (z > known);
        store(depth, select(wins, z, known));
        store(owner, select(wins, I(triangle), load<I>(owner)));
    }

    // Of a row of blocks: which the triangle may touch, and which it covers entirely.
    void classify_row(std::int32_t row, std::uint32_t& touched, std::uint32_t& full) const {
        std::uint32_t outside = 0;
        std::uint32_t partial = 0;
        for (int first = 0; first < columns_; first += N) {
            const I column = iota<I>() + I(first);
            M out = false;
            M part = false;
            for (std::size_t i = 0; i < 3; ++i) {
                const I e = I(e_[i] + b_[i] * block_size * row) + I(a_[i] * block_size) * column;
                const std::int32_t a = a_[i] * (block_size - 1);
                const std::int32_t b = b_[i] * (block_size - 1);
                out = out | (e + I(std::max(a, 0) + std::max(b, 0)) < I(0));
                part = part | (e + I(std::min(a, 0) + std::min(b, 0)) < I(0));
            }
            outside |= lane_bits(out) << first;
            partial |= lane_bits(part) << first;
        }
        touched = ~outside & ((1U << columns_) - 1);
        full = ~partial;
    }

    template <bool full>
    void draw_block(std::int32_t column, std::int32_t row, float* depth, std::int32_t* owner,
                    std::int32_t triangle) const {
        const T block_x(static_cast<float>(column * block_size));
        const T block_y(static_cast<float>(row * block_size));
        for (int p = 0; p < parts; ++p) {
            M inside = true;
            if constexpr (!full) {
                I signs(0);
                for (std::size_t i = 0; i < 3; ++i) {
                    signs =
                        signs | (within_[i][p] + I((a_[i] * column + b_[i] * row) * block_size));
                }
                inside = signs >= I(0);
            }
            put(inside, x_[p] + block_x, y_[p] + block_y, depth + p * N, owner + p * N, triangle);
        }
    }

    std::int32_t first_column_, first_row_, columns_, rows_;  // blocks
    std::int32_t e_[3], a_[3], b_[3];
    I within_[3][parts];  // E of the first block's pixels
    T x_[parts], y_[parts];
    T dzdx_, dzdy_, z_, low_, high_;
};

template <int N>
class TileVisibility {
    using T = typename Lanes<N>::Float;
    using I = typename Lanes<N>::Int;

  public:
    TileVisibility(const Frame& frame, TileBuffer& tile)
        : frame_(frame), tile_(tile), offsets_(sample_offsets(frame.settings.samples)) {
        for (const SampleOffset o : offsets_) {
            range_.low = {std::min(range_.low.x, o.x), std::min(range_.low.y, o.y)};
            range_.high = {std::max(range_.high.x, o.x), std::max(range_.high.y, o.y)};
        }
    }

    void draw(const TileBins& bins, std::uint32_t chunk, std::span<const TriangleRef> refs) {
        const std::size_t known = tile_.triangles.size();
        tile_.triangles.resize(known + refs.size());
        for (std::size_t i = 0; i < refs.size(); ++i) {
            tile_.triangles[known + i] = {chunk, refs[i]};
        }
        for (std::size_t i = 0; i < refs.size(); i += N) {
            draw_group(bins, refs.subspan(i, std::min<std::size_t>(N, refs.size() - i)));
        }
    }

  private:
    // Up to N triangles.
    void draw_group(const TileBins& bins, std::span<const TriangleRef> refs) {
        TileSetup<N> setup;
        const auto all_lanes = static_cast<std::uint32_t>((std::uint64_t{1} << refs.size()) - 1);
        const std::uint32_t done = set_up_group(refs, setup);
        for (std::uint32_t left = all_lanes & ~done; left != 0; left &= left - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(left));
            set_up_any(triangle(bins, refs[lane]), tile_, frame_.settings.cull, range_, lane,
                       setup);
        }
        const std::uint32_t drawn = all_lanes & lanes_drawn(setup);
        for (std::size_t s = 0; s < offsets_.size() && drawn != 0; ++s) {
            draw_sample(setup, s, drawn);
        }
        next_ += static_cast<std::int32_t>(refs.size());
    }

    static std::uint32_t lanes_drawn(const TileSetup<N>& t) {
        const auto columns = load<I>(t.x0.data()) <= load<I>(t.x1.data());
        const auto rows = load<I>(t.y0.data()) <= load<I>(t.y1.data());
        return lane_bits(columns & rows);
    }

    void draw_sample(const TileSetup<N>& setup, std::size_t s, std::uint32_t drawn) {
        SampleSetup<N> sample;
        place_sample(setup, tile_, offsets_[s], sample);
        float* depth = &tile_.depth[s * tile_pixels];
        std::int32_t* owner = &tile_.owner[s * tile_pixels];
        for (; drawn != 0; drawn &= drawn - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(drawn));
            Coverage<N>(setup, sample, lane)
                .draw(depth, owner, next_ + static_cast<std::int32_t>(lane));
        }
    }

    // Sets up the small triangles of the group; bit i says that it did lane i.
    std::uint32_t set_up_group(std::span<const TriangleRef> refs, TileSetup<N>& setup) {
        std::array<std::uint32_t, 3 * N> corner;
        for (std::size_t i = 0; i < N; ++i) {
            const TriangleRef ref = refs[std::min(i, refs.size() - 1)];
            if ((ref & piece_bit) != 0) {
                return 0;  // pieces of clipped triangles, one by one
            }
            const glm::uvec3& t = frame_.mesh->triangles[ref];
            corner[i] = t.x;
            corner[i + N] = t.y;
            corner[i + 2 * N] = t.z;
        }
        I x[3];
        I y[3];
        T z[3];
        for (std::size_t i = 0; i < 3; ++i) {
            const LaneVertices<N> v = load_vertices<N>(*frame_.vertices, &corner[i * N]);
            x[i] = v.x;
            y[i] = v.y;
            z[i] = v.z;
        }
        const I extent = max(max(max(x[0], x[1]), x[2]) - min(min(x[0], x[1]), x[2]),
                             max(max(y[0], y[1]), y[2]) - min(min(y[0], y[1]), y[2]));
        const auto small = lane_bits(extent < I(tile_size * subpixel_one));
        if (small != 0) {
            set_up_small<N>(x, y, z, tile_, frame_.settings.cull, range_, setup);
        }
        return small;
    }

    ScreenTriangle triangle(const TileBins& bins, TriangleRef ref) const {
        return (ref & piece_bit) != 0 ? bins.piece(ref) : screen_triangle(frame_, {0, ref});
    }

    const Frame& frame_;
    TileBuffer& tile_;
    std::span<const SampleOffset> offsets_;
    OffsetRange range_;
    std::int32_t next_ = 0;  // the group's place in tile_.triangles
};

// What lies beyond the window's edge is not there.
void clear_outside(const Frame& frame, TileBuffer& tile) {
    const int width = frame.view.width - tile.x;
    const int height = frame.view.height - tile.y;
    if (width >= tile_size && height >= tile_size) {
        return;
    }
    for (std::size_t i = 0; i < tile.depth.size(); ++i) {
        const int pixel = static_cast<int>(i % tile_pixels);
        if (pixel_column(pixel) >= width || pixel_row(pixel) >= height) {
            tile.depth[i] = 0.0F;
        }
    }
}

}  // namespace

bool find_visible(const Frame& frame, std::size_t tile, TileBuffer& buffer) {
    const auto columns = static_cast<std::size_t>(frame.grid.columns);
    buffer.x = static_cast<int>(tile % columns) * tile_size;
    buffer.y = static_cast<int>(tile / columns) * tile_size;
    buffer.triangles.clear();
    const auto touched = [tile](const TileBins& bins) { return !bins.tile(tile).empty(); };
    if (std::none_of(frame.chunks.begin(), frame.chunks.end(), touched)) {
        return false;
    }
    const auto samples = static_cast<std::size_t>(frame.settings.samples) * tile_pixels;
    buffer.depth.assign(samples, 0.0F);
    buffer.owner.resize(samples);
    with_lanes(frame.settings.lanes, [&]<int N>() {
        TileVisibility<N> visibility(frame, buffer);
        for (std::size_t chunk = 0; chunk < frame.chunks.size(); ++chunk) {
            const TileBins& bins = frame.chunks[chunk];
            visibility.draw(bins, static_cast<std::uint32_t>(chunk), bins.tile(tile));
        }
    });
    clear_outside(frame, buffer);
    return true;
}

}  // namespace glint
