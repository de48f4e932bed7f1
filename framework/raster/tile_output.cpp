// Stage 5 of the tile rasterizer: a tile into the target's pictures.
#include "framework/raster/tile.hpp"
#include "framework/math/dispatch.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

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

// Streams rows of the tile, side by side in codes, to a picture from pixel x, y on.
void stream_rows(const Frame& frame, const std::int32_t* codes, int rows, int x, int y) {
    with_lanes(frame.settings.lanes, [&]<int N>() {
        using I = typename Lanes<N>::Int;
        for (int row = 0; row < rows; ++row, codes += tile_size) {
            auto* out = reinterpret_cast<std::int32_t*>(&(*frame.target.srgb)(x, y + row));
            for (int i = 0; i < tile_size; i += N) {
                store_streaming(out + i, load<I>(codes + i));
            }
        }
    });
}

// Four pixels of a block lie side by side in the tile as in the picture.
void write_codes(const Frame& frame, const TileBuffer& tile) {
    static_assert(sizeof(Rgba8) == sizeof(tile.codes[0]));
    const auto [columns, rows] = extent(frame, tile.x, tile.y);
    const bool aligned = is_aligned(*frame.target.srgb, {columns, rows});
    std::array<std::int32_t, block_size * tile_size> lines;
    for (int y = 0; y < rows; y += block_size) {
        const std::int32_t* block = &tile.codes[pixel_place(0, y)];
        for (int x = 0; x < tile_size; x += block_size) {
            for (int row = 0; row < block_size; ++row, block += block_size) {
                std::memcpy(&lines[static_cast<std::size_t>(row * tile_size + x)], block,
                            block_size * sizeof(Rgba8));
            }
        }
        const int count = std::min(block_size, rows - y);
        if (aligned) {
            stream_rows(frame, lines.data(), count, tile.x, tile.y + y);
            continue;
        }
        for (int row = 0; row < count; ++row) {
            std::memcpy(&(*frame.target.srgb)(tile.x, tile.y + y + row),
                        &lines[static_cast<std::size_t>(row * tile_size)],
                        static_cast<std::size_t>(columns) * sizeof(Rgba8));
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

void write_tile(const Frame& frame, TileBuffer& tile) {
    if (frame.target.srgb != nullptr) {
        if (keeps_colour(frame)) {
            encode(frame, tile);
        }
        write_codes(frame, tile);
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

void write_empty_tile(const Frame& frame, int x, int y) {
    const Target& target = frame.target;
    const Rgb<float>& c = target.background;
    const std::int32_t code = opaque_code(c.r, c.g, c.b);
    const Extent tile = extent(frame, x, y);
    if (target.srgb != nullptr && is_aligned(*target.srgb, tile)) {
        std::array<std::int32_t, tile_size> line;
        line.fill(code);
        for (int row = 0; row < tile.rows; ++row) {
            stream_rows(frame, line.data(), 1, x, y + row);
        }
        finish_streaming();
    } else {
        fill(frame, x, y, target.srgb, std::bit_cast<Rgba8>(code));
    }
    fill(frame, x, y, target.linear, target.background);
    fill(frame, x, y, target.depth, 0.0F);
    fill(frame, x, y, target.triangle, no_triangle);
}

}  // namespace glint
