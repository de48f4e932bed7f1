// Stage 4, first part: what is shaded in a tile, and where.
#include "framework/raster/fragment.hpp"
#include "framework/raster/tile.hpp"
#include "framework/math/dispatch.hpp"

#include <algorithm>

namespace glint {
namespace {

template <int N>
class FragmentList {
    using T = typename Lanes<N>::Float;
    using I = typename Lanes<N>::Int;
    using M = typename Lanes<N>::Mask;

  public:
    FragmentList(const Frame& frame, TileBuffer& tile)
        : tile_(tile),
          samples_(static_cast<std::size_t>(frame.settings.samples)),
          sample_shading_(frame.settings.sample_shading) {}

    void list() {
        const std::size_t most = tile_pixels * samples_ + block_pixels;
        tile_.fragment_pixel.resize(most);
        tile_.fragment_triangle.resize(most);
        if (samples_ > 1) {
            tile_.covered = false;
            tile_.fragment_sample.resize(most);
            list_multisampled();
            return;
        }
        tile_.covered = covers_all();
        if (tile_.covered) {
            tile_.fragments = tile_pixels;
        } else {
            list_single();
        }
    }

  private:
    bool covers_all() const {
        const float* depth = tile_.depth.data();
        for (int pixel = 0; pixel < tile_pixels; pixel += 4 * N, depth += 4 * N) {
            const T least = min(min(load<T>(depth), load<T>(depth + N)),
                                min(load<T>(depth + 2 * N), load<T>(depth + 3 * N)));
            if (!all(least > T(0.0F))) {
                return false;
            }
        }
        return true;
    }

    // One sample a pixel. All is local, for what is stored might be what the tile's members are.
    void list_single() {
        const float* depth = tile_.depth.data();
        const std::int32_t* owner = tile_.owner.data();
        std::int32_t* pixels = tile_.fragment_pixel.data();
        std::int32_t* triangles = tile_.fragment_triangle.data();
        std::ptrdiff_t count = 0;
        for (int pixel = 0; pixel < tile_pixels; pixel += N) {
            const M there = load<T>(depth + pixel) > T(0.0F);
            store_compressed(pixels + count, there, iota<I>() + I(pixel));
            count += store_compressed(triangles + count, there, load<I>(owner + pixel));
        }
        tile_.fragments = static_cast<std::size_t>(count);
    }

    // Of N pixels together: those of their first samples, then what is new at the second, ...
    void list_multisampled() {
        std::int32_t* pixels = tile_.fragment_pixel.data();
        std::int32_t* triangles = tile_.fragment_triangle.data();
        std::int32_t* samples = tile_.fragment_sample.data();
        std::ptrdiff_t listed = 0;
        std::array<I, max_samples> won;
        for (int pixel = 0; pixel < tile_pixels; pixel += N) {
            for (std::size_t s = 0; s < samples_; ++s) {
                const std::size_t at = s * tile_pixels + static_cast<std::size_t>(pixel);
                const M there = load<T>(&tile_.depth[at]) > T(0.0F);
                won[s] = select(there, load<I>(&tile_.owner[at]), I(no_triangle));
            }
            resolve_pixels<I>({won.data(), samples_}, sample_shading_,
                              [&](M where, const I& triangle, std::size_t sample, const I& count) {
                                  store_compressed(pixels + listed, where, iota<I>() + I(pixel));
                                  store_compressed(
                                      samples + listed, where,
                                      sample_and_count(I(static_cast<int>(sample)), count));
                                  listed += store_compressed(triangles + listed, where, triangle);
                              });
        }
        tile_.fragments = static_cast<std::size_t>(listed);
    }

    TileBuffer& tile_;
    std::size_t samples_;
    bool sample_shading_;
};

// The owner of each run of fragments; returns how many runs there are.
template <int N>
std::size_t list_runs(TileBuffer& tile, std::int32_t* run) {
    using I = typename Lanes<N>::Int;
    const auto fragments = static_cast<std::int32_t>(tile.fragments);
    std::int32_t* owner = tile.owners();
    std::fill_n(owner + fragments, N, no_triangle);  // ends the last run
    std::ptrdiff_t count = 0;
    for (std::int32_t i = 0; i < fragments; i += N) {
        const I here = load<I>(owner + i);
        const auto last = here != load<I>(owner + i + 1);
        count += store_compressed(run + count, last, here);
    }
    return static_cast<std::size_t>(count);
}

// Marks the triangles that own fragments. No branch to mispredict.
template <int N>
void mark_owners(TileBuffer& tile) {
    tile.owns.assign(tile.triangles.size() + N, 0);
    tile.sorted[0].resize(tile.fragment_triangle.size());
    std::int32_t* run = tile.sorted[0].data();
    for (std::size_t i = 0, runs = list_runs<N>(tile, run); i < runs; ++i) {
        tile.owns[static_cast<std::size_t>(run[i])] = 1;
    }
}

}  // namespace

void list_fragments(const Frame& frame, TileBuffer& tile) {
    with_lanes(frame.settings.lanes, [&]<int N>() {
        FragmentList<N>(frame, tile).list();
        mark_owners<N>(tile);
    });
    if (frame.shaders.size() > 1) {
        sort_by_shader(frame, tile);
    } else {
        tile.shader_end.assign(1, static_cast<std::uint32_t>(tile.fragments));
    }
}

}  // namespace glint
