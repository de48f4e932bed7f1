// Stage 5 of the tile rasterizer: a tile into the target's pictures.
#include "framework/raster/tile.hpp"
#include "framework/image/srgb.hpp"

#include <algorithm>

namespace glint {
namespace {

Rgba8 encode(const Rgb<float>& c) {
    return {linear_to_srgb(c.r), linear_to_srgb(c.g), linear_to_srgb(c.b), 255};
}

// Calls visit(x, y, pixel) for the pixels of the tile that are inside the window.
template <class Visit>
void for_each_pixel(const Frame& frame, int x, int y, Visit&& visit) {
    const int columns = std::min(tile_size, frame.view.width - x);
    const int rows = std::min(tile_size, frame.view.height - y);
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const int block = (row / block_size) * tile_blocks + column / block_size;
            const int within = (row % block_size) * block_size + column % block_size;
            visit(x + column, y + row, static_cast<std::size_t>(block * block_pixels + within));
        }
    }
}

template <class Pixel>
void fill_tile(const Frame& frame, int x, int y, Image<Pixel>* image, const Pixel& value) {
    if (image != nullptr) {
        for_each_pixel(frame, x, y, [&](int px, int py, std::size_t) { (*image)(px, py) = value; });
    }
}

}  // namespace

void write_tile(const Frame& frame, const TileBuffer& buffer) {
    const Target& target = frame.target;
    for_each_pixel(frame, buffer.x, buffer.y, [&](int x, int y, std::size_t pixel) {
        const Rgb<float> c{buffer.colour[0][pixel], buffer.colour[1][pixel],
                           buffer.colour[2][pixel]};
        if (target.srgb != nullptr) {
            (*target.srgb)(x, y) = encode(c);
        }
        if (target.linear != nullptr) {
            (*target.linear)(x, y) = c;
        }
        const bool there = buffer.depth[pixel] > 0.0F;
        if (target.depth != nullptr) {
            (*target.depth)(x, y) = buffer.depth[pixel];
        }
        if (target.triangle != nullptr) {
            (*target.triangle)(x, y) = no_triangle;
            if (there) {
                const auto owner = static_cast<std::size_t>(buffer.owner[pixel]);
                (*target.triangle)(x, y) =
                    static_cast<std::int32_t>(source_of(frame, buffer.triangles[owner]));
            }
        }
    });
}

void write_empty_tile(const Frame& frame, int x, int y) {
    const Target& target = frame.target;
    fill_tile(frame, x, y, target.srgb, encode(target.background));
    fill_tile(frame, x, y, target.linear, target.background);
    fill_tile(frame, x, y, target.depth, 0.0F);
    fill_tile(frame, x, y, target.triangle, no_triangle);
}

}  // namespace glint
