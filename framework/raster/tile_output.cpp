// Stage 5 of the tile rasterizer: a tile into the target's pictures.
#include "framework/raster/tile.hpp"
#include "framework/math/dispatch.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>

namespace glint {
namespace {

// The part of a tile that lies inside the window.
struct Extent {
    int columns, rows;
};
Extent extent(const Frame& frame, int x, int y) {
    return {std::min(tile_size, frame.view.width - x), std::min(tile_size, frame.view.height - y)};
}

void encode(const Frame& frame, TileBuffer& tile) {
    tile.codes.resize(tile_pixels);
    with_lanes(frame.settings.lanes, [&]<int N>() {
        using T = typename Lanes<N>::Float;
        for (std::size_t i = 0; i < tile_pixels; i += N) {
            store(&tile.codes[i],
                  opaque_code(load<T>(&tile.colour[0][i]), load<T>(&tile.colour[1][i]),
                              load<T>(&tile.colour[2][i])));
        }
    });
}

// Whether whole rows of a tile can be streamed into a picture.
bool is_aligned(const SrgbImage& picture, Extent tile) {
    constexpr std::uintptr_t line = 64;
    return tile.columns == tile_size &&
           static_cast<std::size_t>(picture.width()) % (line / sizeof(Rgba8)) == 0 &&
           reinterpret_cast<std::uintptr_t>(picture.pixels().data()) % line == 0;
}

// Streams a row of a tile to the picture from pixel x, y on: its codes, in fours a stride apart.
template <int N>
void stream_row(const Frame& frame, const std::int32_t* codes, std::ptrdiff_t stride, int x,
                int y) {
    using I = typename Lanes<N>::Int;
    auto* out = reinterpret_cast<std::int32_t*>(&(*frame.target.srgb)(x, y));
    for (int i = 0; i < tile_size; i += N) {
        store_streaming(out + i, load_fours<I>(codes + i / 4 * stride + i % 4, stride));
    }
}

// The tile's rows from rows_written up to `end`. Four pixels of a block lie side by side in the
// tile as in the picture.
template <int N>
void write_codes(const Frame& frame, TileBuffer& tile, int end) {
    static_assert(sizeof(Rgba8) == sizeof(tile.codes[0]) && block_size == 4);
    const auto [columns, rows] = extent(frame, tile.x, tile.y);
    const bool aligned = is_aligned(*frame.target.srgb, {columns, rows});
    for (int& row = tile.rows_written; row < std::min(rows, end); ++row) {
        const std::int32_t* codes = &tile.codes[pixel_place(0, row)];
        if (aligned) {
            stream_row<N>(frame, codes, block_pixels, tile.x, tile.y + row);
            continue;
        }
        for (int x = 0; x < columns; x += block_size, codes += block_pixels) {
            const auto count = static_cast<std::size_t>(std::min(block_size, columns - x));
            std::memcpy(&(*frame.target.srgb)(tile.x + x, tile.y + row), codes,
                        count * sizeof(Rgba8));
        }
    }
}

// Of the empty tiles that wait, up to `count` rows.
template <int N>
void stream_empty(const Frame& frame, TileBuffer& buffer, int count) {
    for (; count > 0 && buffer.empty_written < buffer.empty_tiles.size(); --count) {
        const glm::ivec2 first = buffer.empty_tiles[buffer.empty_written];
        stream_row<N>(frame, frame.background.data(), 0, first.x,
                      first.y + buffer.empty_rows_written);
        if (++buffer.empty_rows_written == extent(frame, first.x, first.y).rows) {
            ++buffer.empty_written;
            buffer.empty_rows_written = 0;
        }
    }
}

// Calls value(place of the pixel in the tile) for each pixel inside the window.
template <class Pixel, class Value>
void write(const Frame& frame, const TileBuffer& tile, Image<Pixel>* image, Value&& value) {
    if (image == nullptr) {
        return;
    }
    const auto [columns, rows] = extent(frame, tile.x, tile.y);
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < columns; ++x) {
            (*image)(tile.x + x, tile.y + y) = value(pixel_place(x, y));
        }
    }
}

template <class Pixel>
void fill(const Frame& frame, int x, int y, Image<Pixel>* image, const Pixel& value) {
    if (image == nullptr) {
        return;
    }
    const auto [columns, rows] = extent(frame, x, y);
    std::array<Pixel, tile_size> line;  // copied faster than filled
    line.fill(value);
    for (int row = 0; row < rows; ++row) {
        std::copy_n(line.data(), columns, &(*image)(x, y + row));
    }
}

}  // namespace

void stream_some(const Frame& frame, TileBuffer& buffer, int ready) {
    constexpr int empty_rows = 8;
    with_lanes(frame.settings.lanes, [&]<int N>() {
        if (ready > 0) {
            write_codes<N>(frame, buffer, ready);
        }
        stream_empty<N>(frame, buffer, empty_rows);
    });
}

void stream_all(const Frame& frame, TileBuffer& buffer) {
    with_lanes(frame.settings.lanes,
               [&]<int N>() { stream_empty<N>(frame, buffer, std::numeric_limits<int>::max()); });
    finish_streaming();
}

void write_tile(const Frame& frame, TileBuffer& tile) {
    if (frame.target.srgb != nullptr) {
        if (keeps_colour(frame)) {
            encode(frame, tile);
        }
        with_lanes(frame.settings.lanes, [&]<int N>() { write_codes<N>(frame, tile, tile_size); });
        finish_streaming();
    }
    write(frame, tile, frame.target.linear, [&](std::size_t at) {
        return Rgb<float>(tile.colour[0][at], tile.colour[1][at], tile.colour[2][at]);
    });
    write(frame, tile, frame.target.depth, [&](std::size_t at) { return tile.depth[at]; });
    write(frame, tile, frame.target.triangle, [&](std::size_t at) {
        const auto owner = static_cast<std::size_t>(tile.owner[at]);
        return tile.depth[at] > 0.0F
                   ? static_cast<std::int32_t>(source_of(frame, tile.triangles[owner]))
                   : no_triangle;
    });
}

void write_empty_tile(const Frame& frame, TileBuffer& buffer) {
    const Target& target = frame.target;
    const int x = buffer.x;
    const int y = buffer.y;
    if (target.srgb != nullptr && is_aligned(*target.srgb, extent(frame, x, y))) {
        buffer.empty_tiles.emplace_back(x, y);
    } else {
        fill(frame, x, y, target.srgb, std::bit_cast<Rgba8>(frame.background[0]));
    }
    fill(frame, x, y, target.linear, target.background);
    fill(frame, x, y, target.depth, 0.0F);
    fill(frame, x, y, target.triangle, no_triangle);
}

}  // namespace glint
