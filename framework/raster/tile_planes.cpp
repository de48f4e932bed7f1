#include "framework/raster/tile_planes.hpp"

#include "framework/raster/interpolate.hpp"

#include <algorithm>
#include <atomic>

namespace glint {
namespace {

void set_up(const Frame& frame, const TileBuffer& tile, const ScreenTriangle& triangle,
            const Planes& planes) {
    const Edges edges = edges_of(triangle.v);
    const double scale = 1.0 / static_cast<double>(std::abs(edges.double_area));
    // Screen barycentrics over w, as planes: at the tile's corner, a pixel right, a pixel down.
    float p[3][3];
    for (int i = 0; i < 3; ++i) {
        const Edge& e = edges.edge[static_cast<std::size_t>(i)];
        const double weight = scale * static_cast<double>(triangle.v[i].inverse_w);
        const std::int64_t corner =
            e.at(tile.x * subpixel_one, tile.y * subpixel_one) + (e.inclusive ? 0 : 1);
        p[0][i] = static_cast<float>(static_cast<double>(corner) * weight);
        p[1][i] = static_cast<float>(static_cast<double>(e.a * subpixel_one) * weight);
        p[2][i] = static_cast<float>(static_cast<double>(e.b * subpixel_one) * weight);
    }
    const CornerVaryings corners =
        corner_varyings(shader_of(frame, triangle.source), *frame.mesh, triangle);
    for (int c = 0; c < 3; ++c) {
        planes.s(c) = p[c][0] + p[c][1] + p[c][2];
        for (int k = 0; k < planes.count; ++k) {
            const auto at = static_cast<std::size_t>(k);
            planes.d(c)[k] = (corners[1][at] - corners[0][at]) * p[c][1] +
                             (corners[2][at] - corners[0][at]) * p[c][2];
        }
    }
    std::copy_n(corners[0].begin(), planes.count, planes.first());
}

}  // namespace

void set_up_planes(const Frame& frame, TileBuffer& tile) {
    tile.plane_start.assign(tile.triangles.size(), -1);
    tile.planes.clear();
    for (std::size_t i = 0; i < tile.fragments; ++i) {
        const std::int32_t owner = tile.fragment_triangle[i];
        const auto at = static_cast<std::size_t>(owner);
        if (tile.plane_start[at] >= 0) {
            continue;
        }
        const ScreenTriangle triangle = screen_triangle(frame, tile.triangles[at]);
        const int varyings = shader_of(frame, triangle.source).varyings;
        tile.plane_start[at] = static_cast<std::int32_t>(tile.planes.size());
        tile.planes.resize(tile.planes.size() + Planes::size(varyings));
        set_up(frame, tile, triangle, planes_of(tile, owner, varyings));
        std::atomic_ref(frame.won_a_sample[triangle.source]).store(1, std::memory_order_relaxed);
    }
}

}  // namespace glint
