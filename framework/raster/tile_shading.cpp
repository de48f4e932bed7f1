// Stage 4, second part: the fragments of a tile, shaded in full registers. Neighbouring fragments
// share a register whatever triangles they belong to.
#include "framework/raster/tile.hpp"
#include "framework/raster/tile_colours.hpp"
#include "framework/raster/tile_planes.hpp"
#include "framework/math/dispatch.hpp"

#include <algorithm>
#include <bit>

namespace glint {
namespace {

// The direction towards the eye over a tile.
template <int N>
class WayToEye {
    using T = typename Lanes<N>::Float;

  public:
    WayToEye(const Frame& frame, const TileBuffer& tile)
        : corner_(glm::vec3(frame.rays.at(tile.x, tile.y))),
          right_(glm::vec3(frame.rays.right)),
          down_(glm::vec3(frame.rays.down)) {}

    void store_at(T x, T y, float* out) const {
        for (int c = 0; c < 3; ++c) {
            store(out + c * batch, fma(down_[c], y, fma(right_[c], x, corner_[c])));
        }
    }

  private:
    Vec3<T> corner_, right_, down_;
};

template <int N>
class TileShading {
    using T = typename Lanes<N>::Float;
    using I = typename Lanes<N>::Int;
    using M = typename Lanes<N>::Mask;

  public:
    TileShading(const Frame& frame, TileBuffer& tile)
        : frame_(frame), tile_(tile), colours_(frame, tile), samples_(frame.settings.samples) {
        for (std::size_t s = 0; const SampleOffset o : sample_offsets(samples_)) {
            const float to_pixel = 1.0F / static_cast<float>(subpixel_one);
            sample_x_[s] = static_cast<float>(o.x) * to_pixel;
            sample_y_[s++] = static_cast<float>(o.y) * to_pixel;
        }
    }

    void run() {
        const FlushSubnormals flush;
        colours_.fill_background();
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
        // Colours begin at the same place of a page as varyings. A little further, each would be
        // stored at the place that is read next, which processors tell apart by guessing.
        constexpr std::size_t varyings = max_varyings * batch;
        static_assert(varyings * sizeof(float) % 4096 == 0);
        tile_.shader_values.resize(varyings + 3 * batch);
        float* in = tile_.shader_values.data();
        float* out = in + varyings;
        if (shader.directions_only) {
            interpolate<Form::directions>(shader, begin, n, in);
        } else if (tile_.anchored_at_corners) {
            interpolate<Form::at_corners>(shader, begin, n, in);
        } else {
            interpolate<Form::anywhere>(shader, begin, n, in);
        }
        stream_some(frame_, tile_, rows_ready(begin));
        const auto call = N == 16  ? shader.shade_16
                          : N == 8 ? shader.shade_8
                          : N == 4 ? shader.shade_4
                                   : shader.shade_1;
        call(shader.shader, in, batch, static_cast<int>(n), out);
        colours_.put(begin, n, out);
    }

    // Rows of the tile whose codes are all there when the fragments before this one are shaded.
    int rows_ready(std::size_t fragment) const {
        const bool in_order = frame_.shaders.size() == 1;
        const bool has_codes = frame_.target.srgb != nullptr && !keeps_colour(frame_);
        return in_order && has_codes ? pixel_row(tile_.pixels()[fragment]) & -block_size : 0;
    }

    // What the planes are: see tile_planes.hpp. Those that are anchored at corners have no d0.
    enum class Form { directions, at_corners, anywhere };

    template <Form form>
    void interpolate(const Shader& shader, std::size_t begin, std::size_t n, float* out) const {
        const WayToEye<N> to_eye(frame_, tile_);
        for (std::size_t i = 0; i < n; i += N) {
            const std::size_t count = std::min<std::size_t>(N, n - i);
            const I pixel = load_padded<I>(&tile_.pixels()[begin + i], count);
            T x = to_float(pixel_column(pixel)) + T(0.5F);  // from the tile's corner
            T y = to_float(pixel_row(pixel)) + T(0.5F);
            if (samples_ > 1) {
                const I sample = load_padded<I>(&tile_.fragment_sample[begin + i], count);
                const M centred = sample >> sample_bits == I(samples_);
                x += select(centred, T(0.0F), lookup16(sample_x_.data(), sample));
                y += select(centred, T(0.0F), lookup16(sample_y_.data(), sample));
            }
            interpolate_at<form>(begin + i, count, shader.varyings, x, y, out + i);
            if (shader.to_eye) {
                to_eye.store_at(x, y, out + shader.varyings * batch + i);
            }
        }
    }

    // The varyings of up to N fragments.
    template <Form form>
    void interpolate_at(std::size_t begin, std::size_t n, int varyings, T x, T y,
                        float* out) const {
        const std::int32_t* triangle = &tile_.owners()[begin];
        const I triangles = load_padded<I>(triangle, n);
        const std::int32_t last = triangle[n - 1];
        const M of_first = triangles == I(triangle[0]);
        if (!all(of_first | (triangles == I(last)))) {
            interpolate_across<form>(triangle, n, triangles, varyings, x, y, out);
            return;
        }
        const TrianglePlanes<N> planes(tile_, triangle[0]);
        interpolate_by<form>(planes, x, y, varyings,
                             [&](int k, const T& value) { store(out + k * batch, value); });
        if (last != triangle[0]) {
            const TrianglePlanes<N> others(tile_, last);
            interpolate_by<form>(others, x, y, varyings, [&](int k, const T& value) {
                store(out + k * batch, select(of_first, load<T>(out + k * batch), value));
            });
        }
    }

    // Of several triangles: one round for every two groups. Not inlined, for it would take the
    // registers of what is frequent.
    template <Form form>
    [[gnu::noinline]] void interpolate_across(const std::int32_t* triangle, std::size_t n,
                                              I triangles, int varyings, T x, T y,
                                              float* out) const {
        const I place = triangles & I(N - 1);
        const I groups = triangles - place;
        const auto group_of = [&](std::uint32_t lanes) {
            return triangle[std::countr_zero(lanes)] & -N;
        };
        for (std::uint32_t left = lane_bits(M(true)); left != 0;) {
            const std::int32_t first = group_of(left);
            const M in_first = groups == I(first);
            left &= ~lane_bits(in_first);
            const std::int32_t second = group_of(left | 1U << (n - 1));
            const M in_second = groups == I(second);
            left &= ~lane_bits(in_second);
            const GroupPlanes<N> planes(tile_, first, second,
                                        select(in_first, place, place + I(N)));
            const M mine = in_first | in_second;
            interpolate_by<form>(planes, x, y, varyings, [&](int k, const T& value) {
                store(out + k * batch, select(mine, value, load<T>(out + k * batch)));
            });
        }
    }

    // Calls put(k, varying k) for each. Rounds the same way whatever the planes.
    template <Form form, class Planes, class Put>
    static void interpolate_by(const Planes& planes, T x, T y, int varyings, Put&& put) {
        x -= planes.value(0);
        y -= planes.value(1);
        T w(1.0F);
        if constexpr (form != Form::directions) {
            w = reciprocal(fma(planes.value(3), y, fma(planes.value(2), x, T(1.0F))));
        }
        for (int k = 0; k < varyings; ++k) {
            const T first = planes.value(4 + k);
            const T dx = planes.value(4 + varyings + k);
            const T dy = planes.value(4 + 2 * varyings + k);
            if constexpr (form == Form::directions) {
                put(k, fma(dy, y, fma(dx, x, first)));
            } else if constexpr (form == Form::at_corners) {
                put(k, fma(fma(dy, y, dx * x), w, first));
            } else {
                const T d0 = planes.value(4 + 3 * varyings + k);
                put(k, fma(fma(dy, y, fma(dx, x, d0)), w, first));
            }
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

    const Frame& frame_;
    TileBuffer& tile_;
    TileColours<N> colours_;
    int samples_;
    std::array<float, max_samples> sample_x_{}, sample_y_{};  // from the centre, pixels
};

}  // namespace

void shade_tile(const Frame& frame, TileBuffer& buffer) {
    list_fragments(frame, buffer);
    set_up_planes(frame, buffer);
    buffer.fragments_shaded += static_cast<std::int64_t>(buffer.fragments);
    with_lanes(frame.settings.lanes, [&]<int N>() { TileShading<N>(frame, buffer).run(); });
}

}  // namespace glint
