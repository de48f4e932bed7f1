#include "framework/raster/tile_planes.hpp"

#include "framework/raster/interpolate.hpp"
#include "framework/raster/lane_vertices.hpp"
#include "framework/math/dispatch.hpp"

#include <algorithm>
#include <atomic>
#include <bit>

namespace glint {
namespace {

// Below this extent (64 pixels) the doubled area fits 32 bits.
constexpr std::int32_t small_extent = tile_size * subpixel_one;

template <int N>
class PlaneSetup {
    using T = typename Lanes<N>::Float;
    using I = typename Lanes<N>::Int;
    using M = typename Lanes<N>::Mask;

  public:
    PlaneSetup(const Frame& frame, TileBuffer& tile) : frame_(frame), tile_(tile) {}

    void run() {
        tile_.planes.clear();
        list_owners();
        const std::span<const std::int32_t> owners(tile_.owners);
        for (std::size_t begin = 0; begin < owners.size();) {
            const Shader& shader = shader_of(owners[begin]);
            std::size_t end = begin + 1;
            while (end < owners.size() && end - begin < N && &shader_of(owners[end]) == &shader) {
                ++end;
            }
            set_up_group(owners.subspan(begin, end - begin), shader);
            begin = end;
        }
    }

  private:
    // Each triangle that owns a fragment once, in submission order. No branch to mispredict.
    void list_owners() {
        const std::size_t triangles = tile_.triangles.size();
        auto& starts = tile_.plane_start;
        starts.assign(triangles + N, -1);
        const std::int32_t* owner = tile_.fragment_triangle.data();
        std::int32_t last = -1;
        for (std::size_t i = 0; i < tile_.fragments; i += N) {
            const std::size_t n = std::min<std::size_t>(N, tile_.fragments - i);
            if (n < N || !all(load<I>(owner + i) == I(last))) {
                for (std::size_t j = i; j < i + n; ++j) {
                    last = owner[j];
                    starts[static_cast<std::size_t>(last)] = 0;
                }
            }
        }
        tile_.owners.resize(triangles + N);
        std::size_t count = 0;
        for (std::size_t i = 0; i < triangles; i += N) {
            const I triangle = iota<I>() + I(static_cast<std::int32_t>(i));
            count += static_cast<std::size_t>(
                store_compressed(&tile_.owners[count], load<I>(&starts[i]) == I(0), triangle));
        }
        tile_.owners.resize(count);
    }

    const TileTriangle& triangle(std::int32_t owner) const {
        return tile_.triangles[static_cast<std::size_t>(owner)];
    }
    const Shader& shader_of(std::int32_t owner) const {
        return glint::shader_of(frame_, source_of(frame_, triangle(owner)));
    }

    // Up to N triangles of one shader.
    void set_up_group(std::span<const std::int32_t> owners, const Shader& shader) {
        const std::size_t start = tile_.planes.size();
        tile_.planes.resize(start + N * plane_values(shader.varyings));
        float* planes = &tile_.planes[start];
        const std::uint32_t done = set_up_small(owners, shader, planes);
        for (std::size_t lane = 0; lane < owners.size(); ++lane) {
            const TileTriangle& t = triangle(owners[lane]);
            if ((done >> lane & 1U) == 0) {
                set_up_any(screen_triangle(frame_, t), shader, planes + lane);
            }
            tile_.plane_start[static_cast<std::size_t>(owners[lane])] =
                static_cast<std::int32_t>(start + lane);
            std::atomic_ref(frame_.won_a_sample[source_of(frame_, t)])
                .store(1, std::memory_order_relaxed);
        }
    }

    // The vertices of the lanes' triangles, corner by corner. Thrice vertex 0 where there is no
    // triangle, or a piece of one that was clipped.
    struct Corners {
        std::array<std::uint32_t, 3 * N> vertex{};
        std::uint32_t whole = 0;  // lanes that hold a triangle
    };
    Corners corners(std::span<const std::int32_t> owners) const {
        Corners c;
        for (std::size_t lane = 0; lane < owners.size(); ++lane) {
            const TriangleRef ref = triangle(owners[lane]).ref;
            if ((ref & piece_bit) != 0) {
                continue;
            }
            const glm::uvec3& v = frame_.mesh->triangles[ref];
            c.vertex[lane] = v.x;
            c.vertex[lane + N] = v.y;
            c.vertex[lane + 2 * N] = v.z;
            c.whole |= 1U << lane;
        }
        return c;
    }

    // Turns the values of the corners so that corner 1, or else corner 2, comes first.
    template <class V>
    static void turn(M one, M two, V (&v)[3]) {
        const V old[3] = {v[0], v[1], v[2]};
        for (int i = 0; i < 3; ++i) {
            v[i] = select(one, old[(i + 1) % 3], select(two, old[(i + 2) % 3], old[i]));
        }
    }

    // Sets up the small triangles of a group; bit i says that it did lane i.
    std::uint32_t set_up_small(std::span<const std::int32_t> owners, const Shader& shader,
                               float* planes) {
        Corners c = corners(owners);
        I vertex[3];
        I x[3];
        I y[3];
        T s[3];
        for (std::size_t i = 0; i < 3; ++i) {
            const LaneVertices<N> v = load_vertices<N>(*frame_.vertices, &c.vertex[i * N]);
            vertex[i] = load<I>(reinterpret_cast<const std::int32_t*>(&c.vertex[i * N]));
            x[i] = v.x;
            y[i] = v.y;
            s[i] = v.inverse_w;
        }
        // The farthest first: there S is smallest.
        const M one = (s[1] < s[0]) & (s[1] <= s[2]);
        const M two = (s[2] < s[0]) & (s[2] < s[1]);
        turn(one, two, vertex);
        turn(one, two, x);
        turn(one, two, y);
        turn(one, two, s);
        for (std::size_t i = 0; i < 3; ++i) {
            store(reinterpret_cast<std::int32_t*>(&c.vertex[i * N]), vertex[i]);
        }
        const I width = max(max(x[0], x[1]), x[2]) - min(min(x[0], x[1]), x[2]);
        const I height = max(max(y[0], y[1]), y[2]) - min(min(y[0], y[1]), y[2]);
        const M small = (width < I(small_extent)) & (height < I(small_extent));
        const std::uint32_t done = lane_bits(small) & c.whole;
        if (done == 0) {
            return 0;
        }
        const I dx1 = select(small, x[1] - x[0], I(0));
        const I dy1 = select(small, y[1] - y[0], I(0));
        const I dx2 = select(small, x[2] - x[0], I(0));
        const I dy2 = select(small, y[2] - y[0], I(0));
        const T scale = T(static_cast<float>(subpixel_one)) / to_float(dx1 * dy2 - dx2 * dy1);
        // Screen barycentrics of corners 1 and 2, a pixel right and a pixel down.
        const T right[2] = {to_float(dy2) * scale, -to_float(dy1) * scale};
        const T down[2] = {-to_float(dx2) * scale, to_float(dx1) * scale};
        const T to_pixel(1.0F / static_cast<float>(subpixel_one));
        store(planes, to_float(x[0] - I(tile_.x * subpixel_one)) * to_pixel);
        store(planes + N, to_float(y[0] - I(tile_.y * subpixel_one)) * to_pixel);
        store(planes + 2 * N, s[0]);
        store(planes + 3 * N, right[0] * (s[1] - s[0]) + right[1] * (s[2] - s[0]));
        store(planes + 4 * N, down[0] * (s[1] - s[0]) + down[1] * (s[2] - s[0]));

        set_up_varyings(c, shader, s, right, down, planes);
        return done;
    }

    void set_up_varyings(const Corners& c, const Shader& shader, const T (&s)[3],
                         const T (&right)[2], const T (&down)[2], float* planes) const {
        const auto count = static_cast<std::size_t>(shader.varyings);
        std::array<float, 3 * N * max_varyings + 4> varyings;  // the last row of four may stick out
        shader.vertex(shader.shader, *frame_.mesh, c.vertex.data(), 3 * N, varyings.data());
        for (std::size_t k = 0; k < count; k += 4) {
            Rows<T> corner[3];
            for (std::size_t i = 0; i < 3; ++i) {
                const float* rows[N];
                for (std::size_t lane = 0; lane < N; ++lane) {
                    rows[lane] = &varyings[(i * N + lane) * count + k];
                }
                corner[i] = load_rows<T>(rows);
            }
            for (std::size_t j = 0; j < std::min<std::size_t>(4, count - k); ++j) {
                const T first = corner[0][j];
                const T d1 = (corner[1][j] - first) * s[1];
                const T d2 = (corner[2][j] - first) * s[2];
                float* out = planes + (5 + k + j) * N;
                store(out, first);
                store(out + count * N, T(0.0F));
                store(out + 2 * count * N, d1 * right[0] + d2 * right[1]);
                store(out + 3 * count * N, d1 * down[0] + d2 * down[1]);
            }
        }
    }

    // A triangle of any size: anchored at the tile's corner, in double.
    void set_up_any(const ScreenTriangle& t, const Shader& shader, float* planes) const {
        const Edges edges = edges_of(t.v);
        const double scale = 1.0 / static_cast<double>(std::abs(edges.double_area));
        // Screen barycentrics over w: at the tile's corner, a pixel right, a pixel down.
        float p[3][3];
        for (int i = 0; i < 3; ++i) {
            const Edge& e = edges.edge[static_cast<std::size_t>(i)];
            const double weight = scale * static_cast<double>(t.v[i].inverse_w);
            const std::int64_t corner =
                e.at(tile_.x * subpixel_one, tile_.y * subpixel_one) + (e.inclusive ? 0 : 1);
            p[0][i] = static_cast<float>(static_cast<double>(corner) * weight);
            p[1][i] = static_cast<float>(static_cast<double>(e.a * subpixel_one) * weight);
            p[2][i] = static_cast<float>(static_cast<double>(e.b * subpixel_one) * weight);
        }
        const CornerVaryings c = corner_varyings(shader, *frame_.mesh, t);
        const int count = shader.varyings;
        planes[0] = 0.0F;
        planes[N] = 0.0F;
        for (int i = 0; i < 3; ++i) {
            planes[(2 + i) * N] = p[i][0] + p[i][1] + p[i][2];
            for (int k = 0; k < count; ++k) {
                const auto at = static_cast<std::size_t>(k);
                planes[(5 + k) * N] = c[0][at];
                planes[(5 + (i + 1) * count + k) * N] =
                    (c[1][at] - c[0][at]) * p[i][1] + (c[2][at] - c[0][at]) * p[i][2];
            }
        }
    }

    const Frame& frame_;
    TileBuffer& tile_;
};

}  // namespace

void set_up_planes(const Frame& frame, TileBuffer& tile) {
    with_lanes(frame.settings.lanes, [&]<int N>() { PlaneSetup<N>(frame, tile).run(); });
}

}  // namespace glint
