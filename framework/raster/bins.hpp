// Stage 2 of the tile rasterizer: which triangles may win samples in which tile.
#pragma once

#include "framework/raster/pipeline.hpp"
#include "framework/raster/samples.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace glint {

struct Mesh;

inline constexpr int tile_bits = 6;
inline constexpr int tile_size = 1 << tile_bits;  // pixels

struct TileGrid {
    int columns, rows;
    std::size_t tiles() const {
        return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    }
};
inline TileGrid tile_grid(const View& view) {
    return {(view.width + tile_size - 1) >> tile_bits, (view.height + tile_size - 1) >> tile_bits};
}

// A triangle in a bin: its index in the mesh, or the index of a clipped piece with this bit set.
using TriangleRef = std::uint32_t;
inline constexpr TriangleRef piece_bit = 0x80000000U;

// A chunk of consecutive triangles, sorted into tiles, each tile's in submission order. Triangles
// that face away (where that culls), lie beside the window, or pass between the samples are left
// out; a few that cover no sample remain.
class TileBins {
  public:
    // Replaces the contents by triangles first..last of the mesh.
    void fill(const Mesh& mesh, const View& view, const Settings& settings,
              const VertexBuffer& vertices, std::uint32_t first, std::uint32_t last);

    std::span<const TriangleRef> tile(std::size_t index) const {
        return {refs_.data() + start_[index], start_[index + 1] - start_[index]};
    }
    const ScreenTriangle& piece(TriangleRef ref) const { return pieces_[ref & ~piece_bit]; }
    std::int64_t not_finite() const { return not_finite_; }

  private:
    template <int N>
    void assemble(const Mesh& mesh, const View& view, const VertexBuffer& vertices,
                  std::uint32_t first);
    void assemble_clipped(const Mesh& mesh, const View& view, const VertexBuffer& vertices,
                          std::uint32_t triangle);
    template <int N>
    void stage(const typename Lanes<N>::Int (&x)[3], const typename Lanes<N>::Int (&y)[3],
               typename Lanes<N>::Int ref);
    void sort_by_tile();

    struct Window {  // what stage() needs to know of the view
        std::int32_t width, height, columns;
        OffsetRange offsets;
        bool at_centres;  // one sample a pixel, there
        bool cull_back;
    };
    Window window_{};
    std::size_t tiles_ = 0;

    // Triangles in submission order, before they are sorted: a rectangle of tiles each.
    std::vector<std::int32_t> staged_ref_, staged_tile_, staged_extent_;
    std::size_t staged_ = 0;

    std::vector<TriangleRef> refs_;
    std::vector<std::uint32_t> start_;
    std::vector<ScreenTriangle> pieces_;
    std::int64_t not_finite_ = 0;
};

}  // namespace glint
