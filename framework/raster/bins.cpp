#include "framework/raster/bins.hpp"

#include "framework/raster/clip.hpp"
#include "framework/raster/lane_edges.hpp"
#include "framework/raster/lane_vertices.hpp"
#include "framework/geometry/mesh.hpp"
#include "framework/math/dispatch.hpp"

#include <algorithm>

namespace glint {
namespace {

constexpr int half_pixel = subpixel_one / 2;

// Below this extent (64 pixels) the doubled area is exact in 32 bits.
constexpr std::int32_t small_extent = 1 << 14;

template <class I>
I smallest(const I (&v)[3]) {
    return min(min(v[0], v[1]), v[2]);
}
template <class I>
I largest(const I (&v)[3]) {
    return max(max(v[0], v[1]), v[2]);
}

// Where triangles certainly face away, whatever was rounded.
template <int N>
typename Lanes<N>::Mask certainly_faces_away(const typename Lanes<N>::Int (&x)[3],
                                             const typename Lanes<N>::Int (&y)[3]) {
    using T = typename Lanes<N>::Float;
    const T left = to_float(x[1] - x[0]) * to_float(y[2] - y[0]);
    const T right = to_float(x[2] - x[0]) * to_float(y[1] - y[0]);
    return left - right > (abs(left) + abs(right)) * T(0x1p-22F);
}

// Where small triangles have no area or, where that culls, face away.
template <int N>
typename Lanes<N>::Mask culled(const typename Lanes<N>::Int (&x)[3],
                               const typename Lanes<N>::Int (&y)[3], typename Lanes<N>::Mask small,
                               bool cull_back) {
    using I = typename Lanes<N>::Int;
    using M = typename Lanes<N>::Mask;
    const I dx1 = select(small, x[1] - x[0], I(0));
    const I dx2 = select(small, x[2] - x[0], I(0));
    const I area = dx1 * (y[2] - y[0]) - dx2 * (y[1] - y[0]);
    return small & ((area == I(0)) | (M(cull_back) & (area > I(0))));
}

// Where small triangles cover none of the 2x2 pixels' centres from pixel x0, y0 on.
template <int N>
typename Lanes<N>::Mask misses_four_centres(const typename Lanes<N>::Int (&x)[3],
                                            const typename Lanes<N>::Int (&y)[3],
                                            typename Lanes<N>::Int x0, typename Lanes<N>::Int y0) {
    using I = typename Lanes<N>::Int;
    const auto turned = (x[1] - x[0]) * (y[2] - y[0]) < (x[2] - x[0]) * (y[1] - y[0]);
    const I px = (x0 << subpixel_bits) + I(half_pixel);
    const I py = (y0 << subpixel_bits) + I(half_pixel);
    I outside[4] = {I(0), I(0), I(0), I(0)};  // where negative
    for (std::size_t i = 0; i < 3; ++i) {
        const LaneEdge<N> edge = lane_edge<N>(x, y, turned, i, px, py);
        const I right = edge.a << subpixel_bits;
        const I down = edge.b << subpixel_bits;
        outside[0] = outside[0] | edge.e;
        outside[1] = outside[1] | (edge.e + right);
        outside[2] = outside[2] | (edge.e + down);
        outside[3] = outside[3] | (edge.e + right + down);
    }
    return (outside[0] & outside[1] & outside[2] & outside[3]) < I(0);
}

}  // namespace

void TileBins::fill(const Mesh& mesh, const View& view, const Settings& settings,
                    const VertexBuffer& vertices, std::uint32_t first, std::uint32_t last) {
    const TileGrid grid = tile_grid(view);
    window_ = {view.width,
               view.height,
               grid.columns,
               offset_range(settings.samples),
               settings.samples == 1,
               settings.cull == Cull::back};
    tiles_ = grid.tiles();
    staged_ = 0;
    pieces_.clear();
    not_finite_ = 0;
    with_lanes(settings.lanes, [&]<int N>() {
        std::uint32_t i = first;
        for (; i + N <= last; i += N) {
            assemble<N>(mesh, view, vertices, i);
        }
        for (; i < last; ++i) {
            assemble<1>(mesh, view, vertices, i);
        }
    });
    sort_by_tile();
}

// Fetches the corners of N triangles at a time.
template <int N>
void TileBins::assemble(const Mesh& mesh, const View& view, const VertexBuffer& vertices,
                        std::uint32_t first) {
    using I = typename Lanes<N>::Int;
    using M = typename Lanes<N>::Mask;
    I x[3];
    I y[3];
    M clip = false;
    for (int i = 0; i < 3; ++i) {
        const LaneVertices<N> v = load_vertices<N>(vertices, &mesh.triangles[first][i], 3);
        x[i] = v.x;
        y[i] = v.y;
        clip = clip | (v.x == I(needs_clipping));
    }
    if (!any(clip)) {
        stage<N>(x, y, iota<I>() + I(static_cast<std::int32_t>(first)));
        return;
    }
    if constexpr (N == 1) {
        assemble_clipped(mesh, view, vertices, first);
    } else {
        for (std::uint32_t i = 0; i < N; ++i) {
            assemble<1>(mesh, view, vertices, first + i);
        }
    }
}

void TileBins::assemble_clipped(const Mesh& mesh, const View& view, const VertexBuffer& vertices,
                                std::uint32_t triangle) {
    const std::size_t known = pieces_.size();
    if (!clip_triangle(mesh, triangle, view, vertices, pieces_)) {
        ++not_finite_;
    }
    for (std::size_t i = known; i < pieces_.size(); ++i) {
        const ScreenVertex(&v)[3] = pieces_[i].v;
        stage<1>({v[0].x, v[1].x, v[2].x}, {v[0].y, v[1].y, v[2].y},
                 static_cast<std::int32_t>(static_cast<TriangleRef>(i) | piece_bit));
    }
}

// Notes the tiles that N triangles may touch.
template <int N>
void TileBins::stage(const typename Lanes<N>::Int (&x)[3], const typename Lanes<N>::Int (&y)[3],
                     typename Lanes<N>::Int ref) {
    using I = typename Lanes<N>::Int;
    using M = typename Lanes<N>::Mask;
    M alive = true;
    if (window_.cull_back) {  // first, for that is most of a closed mesh
        alive = !certainly_faces_away<N>(x, y);
        if (!any(alive)) {
            return;
        }
    }
    const I left = smallest(x);
    const I right = largest(x);
    const I top = smallest(y);
    const I bottom = largest(y);
    const I x0 = first_pixel(left, window_.offsets.high.x);
    const I y0 = first_pixel(top, window_.offsets.high.y);
    const I x1 = last_pixel(right, window_.offsets.low.x, window_.width - 1);
    const I y1 = last_pixel(bottom, window_.offsets.low.y, window_.height - 1);
    alive = alive & (x0 <= x1) & (y0 <= y1);
    if (!any(alive)) {
        return;
    }
    const M small = (right - left < I(small_extent)) & (bottom - top < I(small_extent));
    alive = alive & !culled<N>(x, y, small, window_.cull_back);
    const M tiny = small & (x1 - x0 <= I(1)) & (y1 - y0 <= I(1));
    if (window_.at_centres && any(alive & tiny)) {
        alive = alive & !(tiny & misses_four_centres<N>(x, y, x0, y0));
    }
    if (staged_ + N > staged_ref_.size()) {
        const std::size_t size = std::max<std::size_t>(2 * staged_ref_.size(), 1024);
        staged_ref_.resize(size);
        staged_tile_.resize(size);
        staged_extent_.resize(size);
    }
    const I column = x0 >> tile_bits;
    const I row = y0 >> tile_bits;
    const I extent = ((x1 >> tile_bits) - column) | (((y1 >> tile_bits) - row) << 16);
    store_compressed(&staged_tile_[staged_], alive, row * I(window_.columns) + column);
    store_compressed(&staged_extent_[staged_], alive, extent);
    staged_ += static_cast<std::size_t>(store_compressed(&staged_ref_[staged_], alive, ref));
}

// A counting sort: stable, so each tile keeps the submission order.
void TileBins::sort_by_tile() {
    const auto for_each_entry = [&](auto&& visit) {
        for (std::size_t i = 0; i < staged_; ++i) {
            if (staged_extent_[i] == 0) [[likely]] {  // lies in one tile
                visit(i, static_cast<std::size_t>(staged_tile_[i]));
                continue;
            }
            const std::int32_t columns = staged_extent_[i] & 0xFFFF;
            const std::int32_t rows = staged_extent_[i] >> 16;
            for (std::int32_t row = 0; row <= rows; ++row) {
                for (std::int32_t column = 0; column <= columns; ++column) {
                    visit(i, static_cast<std::size_t>(staged_tile_[i] + row * window_.columns +
                                                      column));
                }
            }
        }
    };
    start_.assign(tiles_ + 2, 0);
    for_each_entry([&](std::size_t, std::size_t tile) { ++start_[tile + 2]; });
    for (std::size_t tile = 2; tile < start_.size(); ++tile) {
        start_[tile] += start_[tile - 1];
    }
    refs_.resize(start_.back());
    for_each_entry([&](std::size_t i, std::size_t tile) {
        refs_[start_[tile + 1]++] = static_cast<TriangleRef>(staged_ref_[i]);
    });
}

}  // namespace glint
