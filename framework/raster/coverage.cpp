#include "framework/raster/coverage.hpp"

#include "framework/raster/scanline.hpp"
#include "framework/raster/tile.hpp"

#include <algorithm>

namespace glint {
namespace {

using Corners = std::array<glm::ivec2, 3>;

void scan(const Corners& corners, int index, const View& view, const Settings& settings,
          const CoverageSink& sink) {
    ScreenVertex v[3];
    for (std::size_t i = 0; i < 3; ++i) {
        v[i] = {corners[i].x, corners[i].y, 1.0F, 1.0F};
    }
    int sample = 0;
    for (const SampleOffset offset : sample_offsets(settings.samples)) {
        walk_triangle(v, offset, view.width, view.height,
                      [&](int y, int first, int last) { sink(sample, index, y, first, last); });
        ++sample;
    }
}

// Draws one triangle after the other with the stages of the tile rasterizer.
class Tiles {
  public:
    Tiles(const View& view, const Settings& settings)
        : frame_{.mesh = &mesh_,
                 .view = view,
                 .rays = {},
                 .settings = settings,
                 .grid = tile_grid(view),
                 .vertices = &vertices_,
                 .chunks = {&bins_, 1},
                 .shaders = {},
                 .target = {},
                 .background = {},
                 .won_a_sample = {}} {
        mesh_.triangles = {{0, 1, 2}};
    }

    void draw(const Corners& corners, int index, const CoverageSink& sink) {
        for (std::size_t i = 0; i < 3; ++i) {
            vertices_[i] = {.x = corners[i].x, .y = corners[i].y, .z = 1.0F, .inverse_w = 1.0F};
        }
        bins_.fill(mesh_, frame_.view, frame_.settings, vertices_, 0, 1);
        for (std::size_t tile = 0; tile < frame_.grid.tiles(); ++tile) {
            if (find_visible(frame_, tile, buffer_)) {
                for (int s = 0; s < frame_.settings.samples; ++s) {
                    report(s, index, sink);
                }
            }
        }
    }

  private:
    void report(int sample, int index, const CoverageSink& sink) const {
        const int columns = std::min(tile_size, frame_.view.width - buffer_.x);
        const int rows = std::min(tile_size, frame_.view.height - buffer_.y);
        const float* depth = &buffer_.depth[static_cast<std::size_t>(sample) * tile_pixels];
        for (int y = 0; y < rows; ++y) {
            const auto covered = [&](int x) { return depth[pixel_place(x, y)] > 0.0F; };
            for (int x = 0; x < columns; ++x) {
                if (covered(x)) {
                    const int first = x;
                    while (x < columns && covered(x)) {
                        ++x;
                    }
                    sink(sample, index, buffer_.y + y, buffer_.x + first, buffer_.x + x);
                }
            }
        }
    }

    Mesh mesh_;
    VertexBuffer vertices_{3};
    TileBins bins_;
    TileBuffer buffer_;
    Frame frame_;
};

}  // namespace

void find_coverage(std::span<const Corners> triangles, int width, int height,
                   const Settings& settings, const CoverageSink& sink) {
    const View view{.width = width, .height = height};
    Tiles tiles(view, settings);
    int index = 0;
    for (const Corners& corners : triangles) {
        if (settings.rasterizer != Rasterizer::tiles) {
            scan(corners, index, view, settings, sink);
        } else {
            tiles.draw(corners, index, sink);
        }
        ++index;
    }
}

}  // namespace glint
