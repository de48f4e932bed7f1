// The fragments of a tile in the order of their shaders.
#include "framework/raster/tile.hpp"
#include "framework/math/dispatch.hpp"

#include <algorithm>
#include <numeric>

namespace glint {
namespace {

template <int N>
class ShaderSort {
    using I = typename Lanes<N>::Int;
    using M = typename Lanes<N>::Mask;

  public:
    ShaderSort(const Frame& frame, TileBuffer& tile) : frame_(frame), tile_(tile) {}

    void sort() {
        tile_.shader_end.assign(frame_.shaders.size(), 0);
        note_shaders_of_owners();
        if (std::accumulate(tile_.shader_end.begin(), tile_.shader_end.end(), 0U) > 1) {
            note_shaders_of_fragments();
            move_fragments();
            return;
        }
        const auto only = std::find(tile_.shader_end.begin(), tile_.shader_end.end(), 1U);
        std::fill(only, tile_.shader_end.end(), static_cast<std::uint32_t>(tile_.fragments));
    }

  private:
    // And, for the time being, a 1 as the end of each shader that is there.
    void note_shaders_of_owners() {
        for (std::size_t i = 0; i < tile_.triangles.size(); ++i) {
            if (tile_.owns[i] != 0) {
                const std::size_t s = material_of(frame_, source_of(frame_, tile_.triangles[i]));
                tile_.owns[i] = static_cast<std::int32_t>(s) + 1;
                tile_.shader_end[s] = 1;
            }
        }
    }

    void note_shaders_of_fragments() {
        tile_.shader_of_fragment.resize(tile_.fragment_triangle.size());
        std::int32_t* shader = tile_.shader_of_fragment.data();
        const std::int32_t* owner = tile_.owners();
        const std::int32_t* of_triangle = tile_.owns.data();
        for (std::size_t i = 0; i < tile_.fragments; ++i) {
            shader[i] = of_triangle[owner[i]];
        }
        std::fill_n(shader + tile_.fragments, N, 0);
    }

    // A pass for each shader: a tile has few, and whole registers of fragments move at a time.
    void move_fragments() {
        for (LineVector<std::int32_t>& values : tile_.sorted) {
            values.resize(tile_.fragment_triangle.size());
        }
        const std::int32_t* const from[] = {tile_.pixels(), tile_.owners(),
                                            tile_.fragment_sample.data()};
        const std::size_t kinds = frame_.settings.samples > 1 ? 3 : 2;
        const std::int32_t* shader = tile_.shader_of_fragment.data();
        std::ptrdiff_t moved = 0;
        for (std::size_t s = 0; s < frame_.shaders.size(); ++s) {
            const I number(static_cast<std::int32_t>(s) + 1);
            const bool there = tile_.shader_end[s] != 0;
            for (std::size_t i = 0; there && i < tile_.fragments; i += N) {
                const M mine = load<I>(shader + i) == number;
                int count = 0;
                for (std::size_t k = 0; k < kinds; ++k) {
                    count = store_compressed(tile_.sorted[k].data() + moved, mine,
                                             load<I>(from[k] + i));
                }
                moved += count;
            }
            tile_.shader_end[s] = static_cast<std::uint32_t>(moved);
        }
        tile_.fragment_pixel.swap(tile_.sorted[0]);
        tile_.fragment_triangle.swap(tile_.sorted[1]);
        tile_.fragment_sample.swap(tile_.sorted[2]);
        tile_.covered = false;
    }

    const Frame& frame_;
    TileBuffer& tile_;
};

}  // namespace

void sort_by_shader(const Frame& frame, TileBuffer& tile) {
    with_lanes(frame.settings.lanes, [&]<int N>() { ShaderSort<N>(frame, tile).sort(); });
}

}  // namespace glint
