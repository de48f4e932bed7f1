// The tile rasterizer: what is visible first, tile by tile, then each pixel shaded once.
#pragma once

#include "framework/raster/thread_pool.hpp"
#include "framework/raster/tile.hpp"

#include <vector>

namespace glint {

class TileRasterizer {
  public:
    explicit TileRasterizer(const Settings& settings);

    Statistics render(const Mesh& mesh, const View& view, std::span<const Shader> shaders,
                      const Target& target);

  private:
    void transform_vertices(const Mesh& mesh, const View& view);
    void sort_into_tiles(const Mesh& mesh, const View& view);
    void draw_tile(const Frame& frame, std::size_t tile, TileBuffer& buffer);

    Settings settings_;
    ThreadPool pool_;
    VertexBuffer vertices_;
    std::vector<TileBins> chunks_;
    std::size_t chunks_used_ = 0;
    std::vector<TileBuffer> buffers_;  // one a thread
    std::vector<std::uint8_t> won_a_sample_;
};

}  // namespace glint
