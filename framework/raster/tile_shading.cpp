// Stage 4 of the tile rasterizer: the visible fragments of a tile, shaded in full registers.
// Neighbouring fragments share a register whatever triangles they belong to.
#include "framework/raster/fragment.hpp"
#include "framework/raster/interpolate.hpp"
#include "framework/raster/tile.hpp"
#include "framework/math/dispatch.hpp"

#include <algorithm>
#include <atomic>
#include <bit>

namespace glint {
namespace {

constexpr int batch = 256;  // fragments a call of the shader; their varyings stay in the L1 cache

// A triangle's attributes as planes over the tile: with S(x, y) = 1/w, varying k is
//     first[k] + (d0[k] + dx[k] x + dy[k] y) / S(x, y)
// where x and y are pixels from the tile's corner and first[k] is its value at corner 0. Anchored
// at the tile, and relative to a corner, so that nothing large cancels.
struct Planes {
    std::span<float> data;
    int count;

    static std::size_t size(int count) { return 4 + 4 * static_cast<std::size_t>(count); }
    float& s(int i) const { return data[static_cast<std::size_t>(i)]; }  // s0, sx, sy
    float* first() const { return data.data() + 4; }
    float* d(int i) const { return data.data() + 4 + (i + 1) * count; }  // d0, dx, dy
};

std::size_t material(const Frame& frame, std::uint32_t source) {
    const auto& materials = frame.mesh->materials;
    return materials.empty() ? 0 : materials[source];
}

const Shader& shader_of(const Frame& frame, std::uint32_t source) {
    return frame.shaders[material(frame, source)];
}

void set_up_planes(const Frame& frame, const TileBuffer& tile, const ScreenTriangle& triangle,
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

template <int N>
class TileShading {
    using T = typename Lanes<N>::Float;
    using I = typename Lanes<N>::Int;
    using M = typename Lanes<N>::Mask;

  public:
    TileShading(const Frame& frame, TileBuffer& tile)
        : frame_(frame), tile_(tile), offsets_(sample_offsets(frame.settings.samples)) {}

    void run() {
        list_fragments();
        set_up();
        sort_by_shader();
        for (auto& channel : tile_.colour) {
            channel.resize(tile_pixels);
        }
        fill_background();
        std::size_t begin = 0;
        for (std::size_t s = 0; s < frame_.shaders.size(); ++s) {
            const std::size_t end = frame_.shaders.size() == 1 ? count_ : tile_.shader_end[s];
            for (; begin < end; begin += batch) {
                shade(frame_.shaders[s], begin, std::min<std::size_t>(batch, end - begin));
            }
            begin = end;
        }
        tile_.fragments_shaded += static_cast<std::int64_t>(count_);
    }

  private:
    // ---- the list of fragments ----

    void list_fragments() {
        const std::size_t most = tile_pixels * offsets_.size() + block_pixels;
        tile_.fragment_pixel.resize(most);
        tile_.fragment_triangle.resize(most);
        if (offsets_.size() > 1) {
            tile_.fragment_x.resize(most);
            tile_.fragment_y.resize(most);
            tile_.fragment_share.resize(most);
        }
        count_ = 0;
        for (int pixel = 0; pixel < tile_pixels; pixel += N) {
            const T depth = load<T>(&tile_.depth[static_cast<std::size_t>(pixel)]);
            const I owner = load<I>(&tile_.owner[static_cast<std::size_t>(pixel)]);
            if (offsets_.size() == 1) {
                add(depth > T(0.0F), pixel, owner);
            } else {
                list_multisampled(pixel, depth, owner);
            }
        }
    }

    void add(M there, int pixel, I owner) {
        store_compressed(&tile_.fragment_pixel[count_], there, iota<I>() + I(pixel));
        count_ += static_cast<std::size_t>(
            store_compressed(&tile_.fragment_triangle[count_], there, owner));
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
            std::fill_n(&tile_.fragment_x[count_], N, 0.0F);
            std::fill_n(&tile_.fragment_y[count_], N, 0.0F);
            std::fill_n(&tile_.fragment_share[count_], N, 1.0F);
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
        for (int i = 0; i < n; ++i, ++count_) {
            const Fragment& f = fragments[static_cast<std::size_t>(i)];
            const float to_pixel = 1.0F / static_cast<float>(subpixel_one);
            tile_.fragment_pixel[count_] = pixel;
            tile_.fragment_triangle[count_] = f.triangle;
            tile_.fragment_x[count_] = static_cast<float>(f.at.x) * to_pixel;
            tile_.fragment_y[count_] = static_cast<float>(f.at.y) * to_pixel;
            tile_.fragment_share[count_] =
                static_cast<float>(f.samples) / static_cast<float>(offsets_.size());
        }
    }

    // ---- planes of the triangles that own fragments ----

    void set_up() {
        tile_.plane_start.assign(tile_.triangles.size(), -1);
        tile_.planes.clear();
        for (std::size_t i = 0; i < count_; ++i) {
            const auto t = static_cast<std::size_t>(tile_.fragment_triangle[i]);
            if (tile_.plane_start[t] < 0) {
                set_up_triangle(t);
            }
        }
    }

    void set_up_triangle(std::size_t t) {
        const ScreenTriangle triangle = screen_triangle(frame_, tile_.triangles[t]);
        const int varyings = shader_of(frame_, triangle.source).varyings;
        const std::size_t start = tile_.planes.size();
        tile_.plane_start[t] = static_cast<std::int32_t>(start);
        tile_.planes.resize(start + Planes::size(varyings));
        set_up_planes(frame_, tile_, triangle, planes(static_cast<std::int32_t>(t), varyings));
        std::atomic_ref(frame_.won_a_sample[triangle.source]).store(1, std::memory_order_relaxed);
    }

    Planes planes(std::int32_t triangle, int varyings) const {
        const auto start =
            static_cast<std::size_t>(tile_.plane_start[static_cast<std::size_t>(triangle)]);
        return {{&tile_.planes[start], Planes::size(varyings)}, varyings};
    }

    // ---- one shader after the other ----

    // Sorts the fragments by shader, keeping their order otherwise.
    void sort_by_shader() {
        if (frame_.shaders.size() == 1) {
            return;
        }
        tile_.shader_end.assign(frame_.shaders.size() + 1, 0);
        for (std::size_t i = 0; i < count_; ++i) {
            ++tile_.shader_end[material_of(i) + 1];
        }
        for (std::size_t s = 1; s < tile_.shader_end.size(); ++s) {
            tile_.shader_end[s] += tile_.shader_end[s - 1];
        }
        tile_.order.resize(count_);
        for (std::size_t i = 0; i < count_; ++i) {
            tile_.order[tile_.shader_end[material_of(i)]++] = static_cast<std::uint32_t>(i);
        }
        reorder(tile_.fragment_pixel, tile_.sorted_ints);
        reorder(tile_.fragment_triangle, tile_.sorted_ints);
        if (offsets_.size() > 1) {
            reorder(tile_.fragment_x, tile_.sorted_floats);
            reorder(tile_.fragment_y, tile_.sorted_floats);
            reorder(tile_.fragment_share, tile_.sorted_floats);
        }
    }

    std::size_t material_of(std::size_t fragment) const {
        const auto t = static_cast<std::size_t>(tile_.fragment_triangle[fragment]);
        return material(frame_, source_of(frame_, tile_.triangles[t]));
    }

    template <class V>
    void reorder(std::vector<V>& values, std::vector<V>& sorted) {
        sorted.resize(values.size());
        for (std::size_t i = 0; i < count_; ++i) {
            sorted[i] = values[tile_.order[i]];
        }
        values.swap(sorted);
    }

    // ---- shading ----

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
        if (offsets_.size() == 1) {
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
        if (offsets_.size() > 1) {
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
            const Planes p = planes(t, varyings);
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
        const bool everywhere = count_ != tile_pixels || offsets_.size() > 1;
        for (std::size_t c = 0; c < 3 && everywhere; ++c) {
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
    std::span<const SampleOffset> offsets_;
    std::size_t count_ = 0;  // fragments
};

}  // namespace

void shade_tile(const Frame& frame, TileBuffer& buffer) {
    with_lanes(frame.settings.lanes, [&]<int N>() { TileShading<N>(frame, buffer).run(); });
}

}  // namespace glint
