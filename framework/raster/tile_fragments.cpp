// Stage 4, first part: what is shaded in a tile, where, and by which shader.
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
        : frame_(frame), tile_(tile), offsets_(sample_offsets(frame.settings.samples)) {}

    void list() {
        const std::size_t most = tile_pixels * offsets_.size() + block_pixels;
        tile_.fragment_pixel.resize(most);
        tile_.fragment_triangle.resize(most);
        if (offsets_.size() > 1) {
            tile_.fragment_x.resize(most);
            tile_.fragment_y.resize(most);
            tile_.fragment_share.resize(most);
        }
        tile_.fragments = 0;
        tile_.covered = offsets_.size() == 1 && covers_all();
        if (tile_.covered) {
            tile_.fragments = tile_pixels;
            return;
        }
        if (offsets_.size() == 1) {
            list_single();
            return;
        }
        for (int pixel = 0; pixel < tile_pixels; pixel += N) {
            const T depth = load<T>(&tile_.depth[static_cast<std::size_t>(pixel)]);
            const I owner = load<I>(&tile_.owner[static_cast<std::size_t>(pixel)]);
            list_multisampled(pixel, depth, owner);
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

    void add(M there, int pixel, I owner) {
        store_compressed(&tile_.fragment_pixel[tile_.fragments], there, iota<I>() + I(pixel));
        tile_.fragments += static_cast<std::size_t>(
            store_compressed(&tile_.fragment_triangle[tile_.fragments], there, owner));
    }

    void list_multisampled(int pixel, T depth, I owner) {
        M uniform = depth > T(0.0F);
        M nothing = !uniform;
        for (std::size_t s = 1; s < offsets_.size(); ++s) {
            const std::size_t at = s * tile_pixels + static_cast<std::size_t>(pixel);
            const M there = load<T>(&tile_.depth[at]) > T(0.0F);
            uniform = uniform & there & (load<I>(&tile_.owner[at]) == owner);
            nothing = nothing & !there;
        }
        if (all(nothing)) {
            return;
        }
        if (!frame_.settings.sample_shading && all(uniform)) {
            std::fill_n(&tile_.fragment_x[tile_.fragments], N, 0.0F);
            std::fill_n(&tile_.fragment_y[tile_.fragments], N, 0.0F);
            std::fill_n(&tile_.fragment_share[tile_.fragments], N, 1.0F);
            add(uniform, pixel, owner);
            return;
        }
        for (int i = 0; i < N; ++i) {
            list_pixel(pixel + i);
        }
    }

    void list_pixel(int pixel) {
        std::array<std::int32_t, max_samples> won;
        for (std::size_t s = 0; s < offsets_.size(); ++s) {
            const std::size_t at = s * tile_pixels + static_cast<std::size_t>(pixel);
            won[s] = tile_.depth[at] > 0.0F ? tile_.owner[at] : no_triangle;
        }
        std::array<Fragment, max_samples> fragments;
        const int n = resolve_pixel(won, offsets_, frame_.settings.sample_shading, fragments);
        for (int i = 0; i < n; ++i, ++tile_.fragments) {
            const Fragment& f = fragments[static_cast<std::size_t>(i)];
            const float to_pixel = 1.0F / static_cast<float>(subpixel_one);
            tile_.fragment_pixel[tile_.fragments] = pixel;
            tile_.fragment_triangle[tile_.fragments] = f.triangle;
            tile_.fragment_x[tile_.fragments] = static_cast<float>(f.at.x) * to_pixel;
            tile_.fragment_y[tile_.fragments] = static_cast<float>(f.at.y) * to_pixel;
            tile_.fragment_share[tile_.fragments] =
                static_cast<float>(f.samples) / static_cast<float>(offsets_.size());
        }
    }

    const Frame& frame_;
    TileBuffer& tile_;
    std::span<const SampleOffset> offsets_;
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
    tile.sorted_ints.resize(tile.fragment_triangle.size());
    std::int32_t* run = tile.sorted_ints.data();
    for (std::size_t i = 0, runs = list_runs<N>(tile, run); i < runs; ++i) {
        tile.owns[static_cast<std::size_t>(run[i])] = 1;
    }
}

template <class V>
void reorder(const TileBuffer& tile, const V* from, LineVector<V>& values, LineVector<V>& sorted) {
    sorted.resize(values.size());
    for (std::size_t i = 0; i < tile.fragments; ++i) {
        sorted[i] = from[tile.order[i]];
    }
    values.swap(sorted);
}

// A counting sort: fragments of one shader keep their order.
void sort_by_shader(const Frame& frame, TileBuffer& tile) {
    const auto shader_of_fragment = [&](std::size_t i) {
        const auto t = static_cast<std::size_t>(tile.owners()[i]);
        return material_of(frame, source_of(frame, tile.triangles[t]));
    };
    tile.shader_end.assign(frame.shaders.size() + 1, 0);
    for (std::size_t i = 0; i < tile.fragments; ++i) {
        ++tile.shader_end[shader_of_fragment(i) + 1];
    }
    for (std::size_t s = 1; s < tile.shader_end.size(); ++s) {
        tile.shader_end[s] += tile.shader_end[s - 1];
    }
    tile.order.resize(tile.fragments);
    for (std::size_t i = 0; i < tile.fragments; ++i) {
        tile.order[tile.shader_end[shader_of_fragment(i)]++] = static_cast<std::uint32_t>(i);
    }
    reorder(tile, tile.pixels(), tile.fragment_pixel, tile.sorted_ints);
    reorder(tile, tile.owners(), tile.fragment_triangle, tile.sorted_ints);
    tile.covered = false;
    if (frame.settings.samples > 1) {
        for (auto* values : {&tile.fragment_x, &tile.fragment_y, &tile.fragment_share}) {
            reorder(tile, values->data(), *values, tile.sorted_floats);
        }
    }
}

}  // namespace

void list_fragments(const Frame& frame, TileBuffer& tile) {
    with_lanes(frame.settings.lanes, [&]<int N>() {
        FragmentList<N>(frame, tile).list();
        mark_owners<N>(tile);
    });
    if (frame.shaders.size() == 1) {
        tile.shader_end.assign(1, static_cast<std::uint32_t>(tile.fragments));
    } else {
        sort_by_shader(frame, tile);
    }
}

}  // namespace glint
