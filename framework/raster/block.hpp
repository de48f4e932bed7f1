// A block of 4x4 pixels, which lie side by side in a tile's memory, in registers.
#pragma once

#include "framework/raster/tile.hpp"
#include "framework/math/lanes.hpp"

#include <array>
#include <cstdint>

namespace glint {

template <int N>
inline constexpr int block_parts = block_pixels / N;  // registers a block

// Column and row of a block's pixels; and, times 4, of 4x4 blocks.
template <class V>
inline constexpr std::array<V, block_pixels> block_columns{0, 1, 2, 3, 0, 1, 2, 3,
                                                           0, 1, 2, 3, 0, 1, 2, 3};
template <class V>
inline constexpr std::array<V, block_pixels> block_rows{0, 0, 0, 0, 1, 1, 1, 1,
                                                        2, 2, 2, 2, 3, 3, 3, 3};

// A triangle's depth plane, the same in all lanes.
template <int N>
struct BlockDepth {
    typename Lanes<N>::Float z, dzdx, dzdy, low, high;

    // DepthPlane::at(), with the sample's position relative to the anchor.
    typename Lanes<N>::Float at(typename Lanes<N>::Float x, typename Lanes<N>::Float y) const {
        return min(max(z + (dzdx * x + dzdy * y), low), high);
    }
};

// N samples go to the triangle where it covers them and is nearer than what is there. Depths are
// not negative, so the greater is the nearer one: asked for it, not for a choice, the processor
// waits less for the block that it has only just written.
template <int N>
void put_nearer(typename Lanes<N>::Mask covered, typename Lanes<N>::Float z, float* depth,
                std::int32_t* owner, std::int32_t triangle) {
    using T = typename Lanes<N>::Float;
    using I = typename Lanes<N>::Int;
    const T known = load<T>(depth);
    const T mine = select(covered, z, T(0.0F));
    store(depth, max(mine, known));
    store(owner, select(mine > known, I(triangle), load<I>(owner)));
}

}  // namespace glint
