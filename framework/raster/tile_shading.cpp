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
        const FlushSubnormals flush;
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
            interpolate(begin + i, std::min<std::size_t>(N, n - i), shader.varyings, in + i);
        }
        const auto call = N == 16  ? shader.shade_16
                          : N == 8 ? shader.shade_8
                          : N == 4 ? shader.shade_4
                                   : shader.shade_1;
        call(shader.shader, in, batch, static_cast<int>(n), out);
        if (multisampled_) {
            accumulate(begin, n, out);
        } else if (keeps_colour(frame_)) {
            put_colours(begin, n, out);
        } else {
            put_codes(begin, n, out);
        }
    }

    // The varyings of up to N fragments; lanes beyond repeat the last.
    void interpolate(std::size_t begin, std::size_t n, int varyings, float* out) const {
        const I pixel = load_padded<I>(&tile_.fragment_pixel[begin], n);
        T x = to_float(pixel_column(pixel)) + T(0.5F);
        T y = to_float(pixel_row(pixel)) + T(0.5F);
        if (multisampled_) {
            x += load_padded<T>(&tile_.fragment_x[begin], n);
            y += load_padded<T>(&tile_.fragment_y[begin], n);
        }
        const std::int32_t* triangle = &tile_.fragment_triangle[begin];
        const I triangles = load_padded<I>(triangle, n);
        if (all(triangles == I(triangle[0]))) {
            interpolate_within(planes_of<N>(tile_, triangle[0], varyings), x, y, out);
        } else {
            interpolate_across(triangles, triangle, (1U << n) - 1, varyings, x, y, out);
        }
    }

    // All of one triangle.
    static void interpolate_within(const Planes<N>& p, T x, T y, float* out) {
        x -= T(p.x());
        y -= T(p.y());
        const T w = reciprocal(T(p.s(0)) + T(p.s(1)) * x + T(p.s(2)) * y);
        for (int k = 0; k < p.count; ++k) {
            const T d = T(p.d(0, k)) + T(p.d(1, k)) * x + T(p.d(2, k)) * y;
            store(out + k * batch, T(p.first(k)) + d * w);
        }
    }

    // Of several triangles: one round for each.
    void interpolate_across(I triangles, const std::int32_t* triangle, std::uint32_t left,
                            int varyings, T x, T y, float* out) const {
        T s(1.0F);
        T first[max_varyings];
        T d[max_varyings];
        while (left != 0) {
            const std::int32_t t = triangle[std::countr_zero(left)];
            const M mine = triangles == I(t);
            const Planes<N> p = planes_of<N>(tile_, t, varyings);
            const T px = x - T(p.x());
            const T py = y - T(p.y());
            s = select(mine, T(p.s(0)) + T(p.s(1)) * px + T(p.s(2)) * py, s);
            for (int k = 0; k < varyings; ++k) {
                first[k] = select(mine, T(p.first(k)), first[k]);
                d[k] = select(mine, T(p.d(0, k)) + T(p.d(1, k)) * px + T(p.d(2, k)) * py, d[k]);
            }
            left &= ~lane_bits(mine);
        }
        const T w = reciprocal(s);
        for (int k = 0; k < varyings; ++k) {
            // All lanes are set. NOLINTNEXTLINE(clang-analyzer-core.UndefinedBinaryOperatorResult)
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
        const Rgb<float>& background = frame_.target.background;
        const bool everywhere = tile_.fragments == tile_pixels && !multisampled_;
        if (!keeps_colour(frame_)) {
            tile_.codes.resize(tile_pixels);
            if (!everywhere) {
                std::fill(tile_.codes.begin(), tile_.codes.end(),
                          opaque_code(background.r, background.g, background.b));
            }
            return;
        }
        for (std::size_t c = 0; c < 3; ++c) {
            tile_.colour[c].resize(tile_pixels);
            if (!everywhere) {
                std::fill(tile_.colour[c].begin(), tile_.colour[c].end(),
                          background[static_cast<int>(c)]);
            }
        }
    }

    void put_colours(std::size_t begin, std::size_t n, const float* rgb) {
        for (std::size_t i = 0; i < n; i += N) {
            for (std::size_t c = 0; c < 3; ++c) {
                put(begin + i, std::min<std::size_t>(N, n - i), load<T>(rgb + c * batch + i),
                    tile_.colour[c].data());
            }
        }
    }

    void put_codes(std::size_t begin, std::size_t n, const float* rgb) {
        for (std::size_t i = 0; i < n; i += N) {
            const I code = opaque_code(load<T>(rgb + i), load<T>(rgb + batch + i),
                                       load<T>(rgb + 2 * batch + i));
            put(begin + i, std::min<std::size_t>(N, n - i), code, tile_.codes.data());
        }
    }

    // The values of n fragments, at most N, to their pixels.
    template <class V, class Scalar>
    void put(std::size_t begin, std::size_t n, const V& values, Scalar* out) const {
        const std::int32_t* pixel = &tile_.fragment_pixel[begin];
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
