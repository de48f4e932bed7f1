// Stage 4, second part: the fragments of a tile, shaded in full registers. Neighbouring fragments
// share a register whatever triangles they belong to.
#include "framework/raster/tile.hpp"
#include "framework/raster/tile_planes.hpp"
#include "framework/math/dispatch.hpp"

#include <algorithm>
#include <bit>

namespace glint {
namespace {

constexpr int batch = 256;  // fragments a call of the shader; their varyings stay in the L1 cache

template <int N>
class TileShading {
    using T = typename Lanes<N>::Float;
    using I = typename Lanes<N>::Int;
    using M = typename Lanes<N>::Mask;

  public:
    TileShading(const Frame& frame, TileBuffer& tile)
        : frame_(frame), tile_(tile), multisampled_(frame.settings.samples > 1) {}

    void run() {
        fill_background();
        std::size_t begin = 0;
        for (std::size_t s = 0; s < frame_.shaders.size(); ++s) {
            const std::size_t end = tile_.shader_end[s];
            for (; begin < end; begin += batch) {
                shade(frame_.shaders[s], begin, std::min<std::size_t>(batch, end - begin));
            }
            begin = end;
        }
    }

  private:
    void shade(const Shader& shader, std::size_t begin, std::size_t n) {
        tile_.varyings.resize(max_varyings * batch);
        tile_.radiance.resize(3 * batch);
        float* in = tile_.varyings.data();
        float* out = tile_.radiance.data();
        for (std::size_t i = 0; i < n; i += N) {
            interpolate_packet(begin + i, std::min<std::size_t>(N, n - i), shader.varyings, in + i);
        }
        const auto call = N == 16  ? shader.shade_16
                          : N == 8 ? shader.shade_8
                          : N == 4 ? shader.shade_4
                                   : shader.shade_1;
        call(shader.shader, in, batch, static_cast<int>(n), out);
        if (!multisampled_) {
            put(begin, n, out);
        } else {
            accumulate(begin, n, out);
        }
    }

    // The varyings of up to N fragments; lanes beyond repeat the last.
    void interpolate_packet(std::size_t begin, std::size_t n, int varyings, float* out) {
        const I pixel = load_padded<I>(&tile_.fragment_pixel[begin], n);
        T x = to_float(pixel_column(pixel)) + T(0.5F);
        T y = to_float(pixel_row(pixel)) + T(0.5F);
        if (multisampled_) {
            x += load_padded<T>(&tile_.fragment_x[begin], n);
            y += load_padded<T>(&tile_.fragment_y[begin], n);
        }
        T s(1.0F);
        T first[max_varyings];
        T d[max_varyings];
        const std::int32_t* triangle = &tile_.fragment_triangle[begin];
        const I triangles = load_padded<I>(triangle, n);
        // One round for each distinct triangle of the packet.
        for (std::uint32_t left = (1U << n) - 1; left != 0;) {
            const std::int32_t t = triangle[std::countr_zero(left)];
            const M mine = triangles == I(t);
            const Planes p = planes_of(tile_, t, varyings);
            s = select(mine, T(p.s(0)) + T(p.s(1)) * x + T(p.s(2)) * y, s);
            for (int k = 0; k < varyings; ++k) {
                first[k] = select(mine, T(p.first()[k]), first[k]);
                d[k] = select(mine, T(p.d(0)[k]) + T(p.d(1)[k]) * x + T(p.d(2)[k]) * y, d[k]);
            }
            left &= ~lane_bits(mine);
        }
        const T w = T(1.0F) / s;
        for (int k = 0; k < varyings; ++k) {
            store(out + k * batch, first[k] + d[k] * w);
        }
    }

    template <class V, class Scalar>
    static V load_padded(const Scalar* from, std::size_t n) {
        if (n == N) {
            return load<V>(from);
        }
        std::array<Scalar, N> padded;
        for (std::size_t i = 0; i < N; ++i) {
            padded[i] = from[std::min(i, n - 1)];
        }
        return load<V>(padded.data());
    }

    // ---- colours into the tile ----

    void fill_background() {
        const bool everywhere = tile_.fragments != tile_pixels || multisampled_;
        for (std::size_t c = 0; c < 3; ++c) {
            tile_.colour[c].resize(tile_pixels);
            if (!everywhere) {
                continue;
            }
            std::fill(tile_.colour[c].begin(), tile_.colour[c].end(),
                      frame_.target.background[static_cast<int>(c)]);
        }
    }

    void put(std::size_t begin, std::size_t n, const float* rgb) {
        const std::int32_t* pixel = &tile_.fragment_pixel[begin];
        for (std::size_t c = 0; c < 3; ++c) {
            float* colour = tile_.colour[c].data();
            const float* from = rgb + c * batch;
            std::size_t i = 0;
            for (; i + N <= n; i += N) {
                if (pixel[i + N - 1] - pixel[i] == N - 1) {
                    store(colour + pixel[i], load<T>(from + i));
                } else {
                    for (std::size_t j = i; j < i + N; ++j) {
                        colour[pixel[j]] = from[j];
                    }
                }
            }
            for (; i < n; ++i) {
                colour[pixel[i]] = from[i];
            }
        }
    }

    // Replaces the background by the fragments' shares of their pixels.
    void accumulate(std::size_t begin, std::size_t n, const float* rgb) {
        for (std::size_t c = 0; c < 3; ++c) {
            const float background = frame_.target.background[static_cast<int>(c)];
            for (std::size_t i = 0; i < n; ++i) {
                const auto pixel = static_cast<std::size_t>(tile_.fragment_pixel[begin + i]);
                tile_.colour[c][pixel] +=
                    (rgb[c * batch + i] - background) * tile_.fragment_share[begin + i];
            }
        }
    }

    const Frame& frame_;
    TileBuffer& tile_;
    bool multisampled_;
};

}  // namespace

void shade_tile(const Frame& frame, TileBuffer& buffer) {
    list_fragments(frame, buffer);
    set_up_planes(frame, buffer);
    buffer.fragments_shaded += static_cast<std::int64_t>(buffer.fragments);
    with_lanes(frame.settings.lanes, [&]<int N>() { TileShading<N>(frame, buffer).run(); });
}

}  // namespace glint
