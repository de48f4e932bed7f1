// Shaded colours, from a batch of fragments into the tile's pixels.
#pragma once

#include "framework/raster/tile.hpp"
#include "framework/math/lanes.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace glint {

// Fragments a call of the shader: their varyings stay in the L1 cache.
inline constexpr int batch = 256;

template <int N>
class TileColours {
    using T = typename Lanes<N>::Float;
    using I = typename Lanes<N>::Int;

  public:
    TileColours(const Frame& frame, TileBuffer& tile)
        : frame_(frame), tile_(tile), samples_(frame.settings.samples) {}

    void fill_background() {
        const bool everywhere = tile_.fragments == tile_pixels && samples_ == 1;
        if (!keeps_colour(frame_)) {
            tile_.codes.resize(tile_pixels);
            if (!everywhere) {
                std::fill(tile_.codes.begin(), tile_.codes.end(), frame_.background[0]);
            }
            return;
        }
        for (std::size_t c = 0; c < 3; ++c) {
            tile_.colour[c].resize(tile_pixels);
            if (!everywhere) {
                std::fill(tile_.colour[c].begin(), tile_.colour[c].end(),
                          frame_.target.background[static_cast<int>(c)]);
            }
        }
    }

    // Of the n fragments from number begin on, as shaders write them: red, green, blue, each a
    // batch apart.
    void put(std::size_t begin, std::size_t n, const float* rgb) {
        if (samples_ > 1) {
            accumulate(begin, n, rgb);
        } else if (keeps_colour(frame_)) {
            put_colours(begin, n, rgb);
        } else {
            put_codes(begin, n, rgb);
        }
    }

  private:
    void put_colours(std::size_t begin, std::size_t n, const float* rgb) {
        for (std::size_t i = 0; i < n; i += N) {
            for (std::size_t c = 0; c < 3; ++c) {
                move(begin + i, std::min<std::size_t>(N, n - i), load<T>(rgb + c * batch + i),
                     tile_.colour[c].data());
            }
        }
    }

    void put_codes(std::size_t begin, std::size_t n, const float* rgb) {
        for (std::size_t i = 0; i < n; i += N) {
            const I code = opaque_code(load<T>(rgb + i), load<T>(rgb + batch + i),
                                       load<T>(rgb + 2 * batch + i));
            move(begin + i, std::min<std::size_t>(N, n - i), code, tile_.codes.data());
        }
    }

    // The values of n fragments, at most N, to their pixels.
    template <class V, class Scalar>
    void move(std::size_t begin, std::size_t n, const V& values, Scalar* out) const {
        const std::int32_t* pixel = &tile_.pixels()[begin];
        if (n == N && pixel[N - 1] - pixel[0] == N - 1) {
            store(out + pixel[0], values);
            return;
        }
        std::array<Scalar, N> value;
        store(value.data(), values);
        for (std::size_t i = 0; i < n; ++i) {
            out[pixel[i]] = value[i];
        }
    }

    // Replaces the background by the fragments' shares of their pixels.
    void accumulate(std::size_t begin, std::size_t n, const float* rgb) {
        const T per_sample(1.0F / static_cast<float>(samples_));  // exact
        for (std::size_t i = 0; i < n; i += N) {
            const I sample = load<I>(&tile_.fragment_sample[begin + i]);
            const T share = to_float(sample >> sample_bits) * per_sample;
            for (std::size_t c = 0; c < 3; ++c) {
                const T background(frame_.target.background[static_cast<int>(c)]);
                add(begin + i, std::min<std::size_t>(N, n - i),
                    load<T>(rgb + c * batch + i) - background, share, tile_.colour[c].data());
            }
        }
    }

    // The products of n fragments, at most N, to what is in their pixels.
    void add(std::size_t begin, std::size_t n, const T& colour, const T& share, float* out) const {
        const std::int32_t* pixel = &tile_.pixels()[begin];
        if (n == N && all(load<I>(pixel) == I(pixel[0]) + iota<I>())) {
            store(out + pixel[0], fma(colour, share, load<T>(out + pixel[0])));
            return;
        }
        std::array<float, N> colours;
        std::array<float, N> shares;
        store(colours.data(), colour);
        store(shares.data(), share);
        for (std::size_t i = 0; i < n; ++i) {
            out[pixel[i]] = fma(colours[i], shares[i], out[pixel[i]]);
        }
    }

    const Frame& frame_;
    TileBuffer& tile_;
    int samples_;
};

}  // namespace glint
