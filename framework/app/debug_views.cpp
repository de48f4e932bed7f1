#include "framework/app/debug_views.hpp"

#include "framework/raster/assemble.hpp"
#include "framework/raster/bins.hpp"
#include "framework/raster/scanline.hpp"
#include "framework/raster/transform.hpp"
#include "framework/image/heat_map.hpp"

#include <algorithm>
#include <cmath>

namespace glint {
namespace {

// A colour from a number, spread over the cube by the bits of a multiplicative hash (Knuth 6.4).
Rgba8 colour_of(std::int32_t number) {
    const std::uint32_t hash = (static_cast<std::uint32_t>(number) + 1) * 2654435761U;
    const auto channel = [hash](int shift) {
        return static_cast<std::uint8_t>(64 + ((hash >> shift) & 255U) * 3 / 4);
    };
    return {channel(24), channel(16), channel(8), 255};
}

template <class From, class Convert>
auto converted(const Image<From>& image, Convert&& convert) {
    Image<decltype(convert(From{}))> out(image.width(), image.height());
    std::transform(image.pixels().begin(), image.pixels().end(), out.pixels().begin(), convert);
    return out;
}

constexpr Rgba8 nothing{0, 0, 0, 255};

}  // namespace

SrgbImage depth_picture(const Image<float>& depth) {
    float low = INFINITY;
    float high = 0.0F;
    for (const float z : depth.pixels()) {
        if (z > 0.0F) {
            low = std::min(low, z);
            high = std::max(high, z);
        }
    }
    // Reversed depth falls like 1 / distance; its logarithm spreads near and far evenly.
    const float range = std::max(std::log(high / low), 1e-6F);
    return converted(depth, [&](float z) -> Rgba8 {
        if (!(z > 0.0F)) {
            return nothing;
        }
        const auto grey = static_cast<std::uint8_t>(40.0F + 215.0F * std::log(z / low) / range);
        return {grey, grey, grey, 255};
    });
}

SrgbImage triangle_picture(const Image<std::int32_t>& triangle) {
    return converted(triangle, [](std::int32_t t) -> Rgba8 {
        return t == no_triangle ? nothing : colour_of(t);
    });
}

Image<float> as_floats(const Image<std::int32_t>& triangle) {
    return converted(triangle, [](std::int32_t t) { return static_cast<float>(t); });
}

Image<float> overdraw(const Mesh& mesh, const View& view, Cull cull) {
    Image<float> count(view.width, view.height, 0.0F);
    for (const ScreenTriangle& t : assemble(mesh, view).triangles) {
        if (culled(edges_of(t.v), cull)) {
            continue;
        }
        walk_triangle(t.v, {0, 0}, view.width, view.height, [&](int y, int first, int last) {
            for (int x = first; x < last; ++x) {
                count(x, y) += 1.0F;
            }
        });
    }
    return count;
}

SrgbImage count_picture(const Image<float>& count) {
    const float most =
        std::max(1.0F, *std::max_element(count.pixels().begin(), count.pixels().end()));
    return converted(count, [most](float n) -> Rgba8 {
        return n == 0.0F ? nothing : heat_colour(0.2F + 0.8F * n / most);
    });
}

Image<float> triangles_by_tile(const Mesh& mesh, const View& view, const Settings& settings) {
    VertexBuffer vertices(mesh.positions.size());
    transform(mesh.positions, view, settings.lanes, 0, mesh.positions.size(), vertices);
    TileBins bins;
    bins.fill(mesh, view, settings, vertices, 0, static_cast<std::uint32_t>(mesh.triangles.size()));
    const TileGrid grid = tile_grid(view);
    Image<float> count(view.width, view.height);
    for (int y = 0; y < view.height; ++y) {
        for (int x = 0; x < view.width; ++x) {
            const int tile = (y >> tile_bits) * grid.columns + (x >> tile_bits);
            count(x, y) = static_cast<float>(bins.tile(static_cast<std::size_t>(tile)).size());
        }
    }
    return count;
}

SrgbImage tile_picture(const Image<float>& count) {
    SrgbImage picture = count_picture(count);
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            if (x % tile_size == 0 || y % tile_size == 0) {
                picture(x, y) = {90, 90, 90, 255};
            }
        }
    }
    return picture;
}

}  // namespace glint
