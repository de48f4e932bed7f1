// One tile of the window while it is drawn: small enough for the cache of a core.
//
// A tile of 64x64 pixels is 16x16 blocks of 4x4; a block's pixels lie side by side in memory, so
// that one register, or a few, hold it.
#pragma once

#include "framework/raster/bins.hpp"
#include "framework/raster/eye_rays.hpp"
#include "framework/raster/pipeline.hpp"
#include "framework/raster/samples.hpp"
#include "framework/raster/shader.hpp"
#include "framework/image/image.hpp"
#include "framework/image/srgb.hpp"
#include "framework/math/memory.hpp"
#include "framework/math/one_lane.hpp"

#include <array>
#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

namespace glint {

inline constexpr int block_bits = 2;
inline constexpr int block_size = 1 << block_bits;
inline constexpr int block_pixels = block_size * block_size;
inline constexpr int tile_blocks = tile_size / block_size;  // a row
inline constexpr int tile_pixels = tile_size * tile_size;

// Column and row, within the tile, of a pixel by its place in memory. I is int or lanes of it.
template <class I>
I pixel_column(I pixel) {
    return ((pixel >> 2) & I(60)) | (pixel & I(3));
}
template <class I>
I pixel_row(I pixel) {
    return ((pixel >> 6) & I(60)) | ((pixel >> 2) & I(3));
}

inline std::size_t pixel_place(int column, int row) {
    const int block = (row / block_size) * tile_blocks + column / block_size;
    return static_cast<std::size_t>(block * block_pixels + (row % block_size) * block_size +
                                    column % block_size);
}

inline constexpr auto all_pixels = [] {
    std::array<std::int32_t, tile_pixels + max_lanes> pixels{};
    std::iota(pixels.begin(), pixels.end(), 0);
    return pixels;
}();

// At which sample a fragment is shaded, and for how many of its pixel's samples it stands; if for
// all, it is shaded at the centre. I is int or lanes of it.
inline constexpr int sample_bits = 4;
static_assert(max_samples == 1 << sample_bits);
template <class I>
I sample_and_count(I sample, I count) {
    return sample + (count << sample_bits);
}

// All that a frame's stages share; read-only while tiles are drawn.
struct Frame {
    const Mesh* mesh;
    View view;
    EyeRays rays;
    Settings settings;
    TileGrid grid;
    const VertexBuffer* vertices;
    std::span<const TileBins> chunks;
    std::span<const Shader> shaders;  // by material
    Target target;
    std::array<std::int32_t, block_size> background;  // its sRGB codes, of four pixels
    std::span<std::uint8_t> won_a_sample;             // by triangle; set where one did
};

// A triangle in a tile: where it stands in the bins.
struct TileTriangle {
    std::uint32_t chunk;
    TriangleRef ref;
};

// The working memory of one thread; it keeps its capacity from tile to tile and frame to frame.
struct TileBuffer {
    int x = 0, y = 0;  // the tile's first pixel

    // What waits to be streamed into the picture: the tile's rows from rows_written on; and empty
    // tiles, by their first pixels: rows of number empty_written from empty_rows_written on, and
    // all tiles behind it.
    int rows_written = 0, empty_rows_written = 0;
    std::size_t empty_written = 0;
    std::vector<glm::ivec2> empty_tiles;

    // By sample, then pixel: depth (0: nothing there) and the place in triangles of who won it;
    // stale where depth is 0.
    LineVector<float> depth;
    LineVector<std::int32_t> owner;
    std::vector<TileTriangle> triangles;

    // Fragments: place of the pixel, place in triangles, and, with more than one sample a pixel, at
    // which sample it is shaded and for how many it stands: see sample_and_count(). Of a tile that
    // is covered everywhere the first two are not listed: they are all its pixels, and owner.
    std::size_t fragments = 0;
    bool covered = false;
    LineVector<std::int32_t> fragment_pixel, fragment_triangle, fragment_sample;

    // By triangle: 1 more than the number of its shader where it owns fragments, else 0. Planes by
    // group: see tile_planes.hpp.
    LineVector<std::int32_t> owns, plane_start;
    LineVector<float> planes;
    bool anchored_at_corners = true;  // all planes of the tile

    // The fragments are sorted by shader: where each shader's end; and scratch for sorting and
    // for runs of fragments.
    LineVector<std::uint32_t> shader_end;
    LineVector<std::int32_t> shader_of_fragment;
    std::array<LineVector<std::int32_t>, 3> sorted;

    LineVector<float> shader_values;          // of a batch of fragments: see tile_shading.cpp
    std::array<LineVector<float>, 3> colour;  // red, green, blue by pixel, if keeps_colour()
    LineVector<std::int32_t> codes;           // sRGB by pixel, as Rgba8 lies in memory

    const std::int32_t* pixels() const {
        return covered ? all_pixels.data() : fragment_pixel.data();
    }
    std::int32_t* owners() { return covered ? owner.data() : fragment_triangle.data(); }
    const std::int32_t* owners() const { return covered ? owner.data() : fragment_triangle.data(); }

    std::int64_t fragments_shaded = 0, tiles_empty = 0;
    double visibility_seconds = 0, shading_seconds = 0, output_seconds = 0;
};

// With one sample a pixel, and no linear picture to write, colours are encoded as they come from
// the shader: less memory is touched.
inline bool keeps_colour(const Frame& frame) {
    return frame.target.linear != nullptr || frame.settings.samples > 1;
}

inline std::uint32_t source_of(const Frame& frame, TileTriangle t) {
    return (t.ref & piece_bit) != 0 ? frame.chunks[t.chunk].piece(t.ref).source : t.ref;
}

inline std::size_t material_of(const Frame& frame, std::uint32_t source) {
    const auto& materials = frame.mesh->materials;
    return materials.empty() ? 0 : materials[source];
}

inline ScreenTriangle screen_triangle(const Frame& frame, TileTriangle t) {
    if ((t.ref & piece_bit) != 0) {
        return frame.chunks[t.chunk].piece(t.ref);
    }
    const glm::uvec3 i = frame.mesh->triangles[t.ref];
    const VertexBuffer& v = *frame.vertices;
    return {.v = {v[i.x], v[i.y], v[i.z]}, .source = t.ref};
}

// Finds who wins each sample of the tile; false where nobody wins any.
bool find_visible(const Frame& frame, std::size_t tile, TileBuffer& buffer);

// Lists the fragments of what find_visible() found, sorted by shader, and who owns them.
void list_fragments(const Frame& frame, TileBuffer& buffer);

// The second part of that, where a frame has several shaders. Those of one shader keep their order.
void sort_by_shader(const Frame& frame, TileBuffer& buffer);

// Shades them into buffer.colour or buffer.codes.
void shade_tile(const Frame& frame, TileBuffer& buffer);

// Streams some of what waits; of the tile, up to the row `ready`. For the shader to be called next:
// ordinary stores wait behind those that pass the caches, and a shader has few.
void stream_some(const Frame& frame, TileBuffer& buffer, int ready);

// Writes the tile into the target's pictures; of an empty one, the picture may wait.
void write_tile(const Frame& frame, TileBuffer& buffer);
void write_empty_tile(const Frame& frame, TileBuffer& buffer);

// Streams all that waits.
void stream_all(const Frame& frame, TileBuffer& buffer);

}  // namespace glint
