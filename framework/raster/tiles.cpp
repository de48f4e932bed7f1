#include "framework/raster/tiles.hpp"

#include "framework/raster/transform.hpp"

#include <algorithm>
#include <chrono>
#include <functional>
#include <numeric>

namespace glint {
namespace {

// Every tile looks into every chunk's bins, so many chunks cost time, few leave threads idle.
constexpr std::size_t chunk_triangles = 4096;
constexpr std::size_t chunks_a_thread = 16;
constexpr std::size_t most_chunks = 256;
constexpr std::size_t vertices_at_a_time = 8192;

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

// Gives a vector of each buffer the room that one of them needed.
template <class Vector>
void level(std::span<TileBuffer> buffers, Vector vector) {
    std::size_t most = 0;
    for (TileBuffer& buffer : buffers) {
        most = std::max(most, std::invoke(vector, buffer).capacity());
    }
    for (TileBuffer& buffer : buffers) {
        std::invoke(vector, buffer).reserve(most);
    }
}

// Next time another thread may draw the fullest tile.
void level_capacities(std::span<TileBuffer> buffers) {
    using B = TileBuffer;
    const auto level_all = [buffers](auto... vector) { (level(buffers, vector), ...); };
    level_all(&B::depth, &B::owner, &B::triangles, &B::fragment_pixel, &B::fragment_triangle,
              &B::fragment_sample, &B::owns, &B::plane_start, &B::planes, &B::shader_end,
              &B::shader_of_fragment, &B::shader_values, &B::codes);
    for (std::size_t i = 0; i < 3; ++i) {
        level(
            buffers, [i](B & b) -> auto& { return b.colour[i]; });
        level(
            buffers, [i](B & b) -> auto& { return b.sorted[i]; });
    }
}

std::array<std::int32_t, block_size> background_codes(const Target& target) {
    const Rgb<float>& c = target.background;
    std::array<std::int32_t, block_size> codes;
    codes.fill(opaque_code(c.r, c.g, c.b));
    return codes;
}

}  // namespace

TileRasterizer::TileRasterizer(const Settings& settings)
    : settings_(settings),
      pool_(settings.threads),
      buffers_(static_cast<std::size_t>(settings.threads)) {}

Statistics TileRasterizer::render(const Mesh& mesh, const View& view,
                                  std::span<const Shader> shaders, const Target& target) {
    const auto start = Clock::now();
    for (TileBuffer& buffer : buffers_) {
        buffer.fragments_shaded = buffer.tiles_empty = 0;
        buffer.visibility_seconds = buffer.shading_seconds = buffer.output_seconds = 0;
        buffer.empty_tiles.clear();
        buffer.empty_written = 0;
        buffer.empty_rows_written = 0;
        buffer.empty_tiles.reserve(tile_grid(view).tiles());
    }
    won_a_sample_.assign(mesh.triangles.size(), 0);
    transform_vertices(mesh, view);
    sort_into_tiles(mesh, view);
    const double geometry_seconds = seconds_since(start);

    const Frame frame{.mesh = &mesh,
                      .view = view,
                      .rays = eye_rays(view),
                      .settings = settings_,
                      .grid = tile_grid(view),
                      .vertices = &vertices_,
                      .chunks = {chunks_.data(), chunks_used_},
                      .shaders = shaders,
                      .target = target,
                      .background = background_codes(target),
                      .won_a_sample = won_a_sample_};
    pool_.run(frame.grid.tiles(), [&](std::size_t tile, int thread) {
        draw_tile(frame, tile, buffers_[static_cast<std::size_t>(thread)]);
    });
    pool_.run(buffers_.size(), [&](std::size_t i, int) {
        const auto drawn = Clock::now();
        stream_all(frame, buffers_[i]);
        buffers_[i].output_seconds += seconds_since(drawn);
    });
    level_capacities(buffers_);

    Statistics s;
    s.frame_ms = 1e3 * seconds_since(start);
    s.geometry_ms = 1e3 * geometry_seconds;
    s.triangles_in = static_cast<std::int64_t>(mesh.triangles.size());
    const double share = 1e3 / pool_.threads();
    for (const TileBuffer& buffer : buffers_) {
        s.fragments_shaded += buffer.fragments_shaded;
        s.tiles_empty += buffer.tiles_empty;
        s.visibility_ms += share * buffer.visibility_seconds;
        s.shading_ms += share * buffer.shading_seconds;
        s.output_ms += share * buffer.output_seconds;
    }
    for (const TileBins& bins : frame.chunks) {
        s.triangles_not_finite += bins.not_finite();
    }
    s.triangles_visible =
        std::accumulate(won_a_sample_.begin(), won_a_sample_.end(), std::int64_t{0});
    return s;
}

void TileRasterizer::transform_vertices(const Mesh& mesh, const View& view) {
    const std::size_t count = mesh.positions.size();
    vertices_.resize(count);
    const std::size_t parts = (count + vertices_at_a_time - 1) / vertices_at_a_time;
    pool_.run(parts, [&](std::size_t part, int) {
        const std::size_t first = part * vertices_at_a_time;
        transform(mesh.positions, view, settings_.lanes, first,
                  std::min(first + vertices_at_a_time, count), vertices_);
    });
}

void TileRasterizer::sort_into_tiles(const Mesh& mesh, const View& view) {
    const std::size_t count = mesh.triangles.size();
    const auto threads = static_cast<std::size_t>(pool_.threads());
    const std::size_t chunks = std::min(chunks_a_thread * threads, most_chunks);
    const std::size_t size = std::max(chunk_triangles, (count + chunks - 1) / chunks);
    chunks_used_ = (count + size - 1) / size;
    if (chunks_.size() < chunks_used_) {
        chunks_.resize(chunks_used_);
    }
    pool_.run(chunks_used_, [&](std::size_t chunk, int) {
        chunks_[chunk].fill(mesh, view, settings_, vertices_,
                            static_cast<std::uint32_t>(chunk * size),
                            static_cast<std::uint32_t>(std::min((chunk + 1) * size, count)));
    });
}

void TileRasterizer::draw_tile(const Frame& frame, std::size_t tile, TileBuffer& buffer) {
    const auto start = Clock::now();
    if (!find_visible(frame, tile, buffer)) {
        write_empty_tile(frame, buffer);
        ++buffer.tiles_empty;
        buffer.output_seconds += seconds_since(start);
        return;
    }
    const auto found = Clock::now();
    shade_tile(frame, buffer);
    const auto shaded = Clock::now();
    write_tile(frame, buffer);
    buffer.visibility_seconds += std::chrono::duration<double>(found - start).count();
    buffer.shading_seconds += std::chrono::duration<double>(shaded - found).count();
    buffer.output_seconds += seconds_since(shaded);
}

}  // namespace glint
