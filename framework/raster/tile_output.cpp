// Stage 5 of the tile rasterizer: a tile into the target's pictures.
#include "framework/raster/tile.hpp"
#include "framework/image/srgb.hpp"
#include "framework/math/dispatch.hpp"

#include <algorithm>
#include <cstring>

namespace glint {
namespace {

Rgba8 encode(const Rgb<float>& c) {
    return {linear_to_srgb(c.r), linear_to_srgb(c.g), linear_to_srgb(c.b), 255};
}

// The part of a tile that lies inside the window.
struct Extent {
    int columns, rows;
};
Extent extent(const Frame& frame, int x, int y) {
    return {std::min(tile_size, frame.view.width - x), std::min(tile_size, frame.view.height - y)};
}

// Encodes a band of four rows, block by block, into codes row by row.
template <int N>
void encode_band(const TileBuffer& tile, int band,
                 std::array<std::uint32_t, 4 * tile_size>& codes) {
    using T = typename Lanes<N>::Float;
    using I = typename Lanes<N>::Int;
    for (int block = 0; block < tile_blocks; ++block) {
        alignas(64) std::int32_t of_block[block_pixels];
        const std::size_t first = pixel_place(block * block_size, band * block_size);
        for (std::size_t i = 0; i < block_pixels; i += N) {
            const I r = srgb_code(load<T>(&tile.colour[0][first + i]));
            const I g = srgb_code(load<T>(&tile.colour[1][first + i]));
            const I b = srgb_code(load<T>(&tile.colour[2][first + i]));
            store(of_block + i, r | (g << 8) | (b << 16) | I(static_cast<int>(0xFF000000U)));
        }
        for (std::size_t row = 0; row < block_size; ++row) {
            std::memcpy(&codes[row * tile_size + static_cast<std::size_t>(block) * block_size],
                        of_block + row * block_size, block_size * sizeof(std::int32_t));
        }
    }
}

template <int N>
void write_srgb(const Frame& frame, const TileBuffer& tile) {
    static_assert(sizeof(Rgba8) == 4);
    const auto [columns, rows] = extent(frame, tile.x, tile.y);
    std::array<std::uint32_t, 4 * tile_size> codes;
    for (int y = 0; y < rows; ++y) {
        if (y % block_size == 0) {
            encode_band<N>(tile, y / block_size, codes);
        }
        std::memcpy(&(*frame.target.srgb)(tile.x, tile.y + y),
                    &codes[static_cast<std::size_t>(y % block_size) * tile_size],
                    static_cast<std::size_t>(columns) * sizeof(Rgba8));
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
    for (int row = 0; row < rows; ++row) {
        std::fill_n(&(*image)(x, y + row), columns, value);
    }
}

}  // namespace

void write_tile(const Frame& frame, const TileBuffer& tile) {
    if (frame.target.srgb != nullptr) {
        with_lanes(frame.settings.lanes, [&]<int N>() { write_srgb<N>(frame, tile); });
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
    fill(frame, x, y, target.srgb, encode(target.background));
    fill(frame, x, y, target.linear, target.background);
    fill(frame, x, y, target.depth, 0.0F);
    fill(frame, x, y, target.triangle, no_triangle);
}

}  // namespace glint
