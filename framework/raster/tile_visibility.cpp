// Stage 3 of the tile rasterizer: depth and owner of every sample of a tile.
#include "framework/raster/lane_vertices.hpp"
#include "framework/raster/large_coverage.hpp"
#include "framework/raster/small_coverage.hpp"
#include "framework/raster/tile.hpp"
#include "framework/raster/tile_setup.hpp"
#include "framework/geometry/mesh.hpp"
#include "framework/math/dispatch.hpp"

#include <algorithm>
#include <bit>

namespace glint {
namespace {

template <int N>
class TileVisibility {
    using T = typename Lanes<N>::Float;
    using I = typename Lanes<N>::Int;

  public:
    TileVisibility(const Frame& frame, TileBuffer& tile)
        : frame_(frame),
          tile_(tile),
          offsets_(sample_offsets(frame.settings.samples)),
          range_(offset_range(frame.settings.samples)) {}

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
        const std::uint32_t small = done & SmallCoverage<N>::fitting(setup);
        for (std::size_t s = 0; s < offsets_.size() && drawn != 0; ++s) {
            draw_sample(setup, s, drawn, small);
        }
        next_ += static_cast<std::int32_t>(refs.size());
    }

    static std::uint32_t lanes_drawn(const TileSetup<N>& t) {
        const auto columns = load<I>(t.x0.data()) <= load<I>(t.x1.data());
        const auto rows = load<I>(t.y0.data()) <= load<I>(t.y1.data());
        return lane_bits(columns & rows);
    }

    // In the order of the lanes: the small ones up to the next large one, then that.
    void draw_sample(const TileSetup<N>& setup, std::size_t s, std::uint32_t drawn,
                     std::uint32_t small) {
        SampleSetup<N> sample;
        place_sample(setup, tile_, offsets_[s], sample);
        SmallCoverage<N> small_ones(setup, sample, next_);
        float* depth = &tile_.depth[s * tile_pixels];
        std::int32_t* owner = &tile_.owner[s * tile_pixels];
        for (std::uint32_t left = drawn; left != 0;) {
            const std::uint32_t large = left & ~small;
            const std::uint32_t before = left & ((large & -large) - 1);
            small_ones.draw(before, depth, owner);
            left &= ~before;
            if (left != 0) {
                const auto lane = static_cast<std::size_t>(std::countr_zero(left));
                LargeCoverage<N>(setup, sample, lane)
                    .draw(depth, owner, next_ + static_cast<std::int32_t>(lane));
                left &= left - 1;
            }
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
    buffer.rows_written = 0;
    buffer.triangles.clear();
    const auto touched = [tile](const TileBins& bins) { return !bins.tile(tile).empty(); };
    if (std::none_of(frame.chunks.begin(), frame.chunks.end(), touched)) {
        return false;
    }
    const auto samples = static_cast<std::size_t>(frame.settings.samples) * tile_pixels;
    buffer.depth.assign(samples, 0.0F);
    buffer.owner.resize(samples + max_lanes);
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
