#include "framework/raster/tile_planes.hpp"

#include "framework/raster/lane_vertices.hpp"
#include "framework/raster/large_planes.hpp"
#include "framework/math/dispatch.hpp"

#include <algorithm>
#include <atomic>
#include <bit>

namespace glint {
namespace {

// Below this extent (128 pixels) the doubled area fits 32 bits.
constexpr std::int32_t small_extent = 128 * subpixel_one;

template <int N>
class PlaneSetup {
    using T = typename Lanes<N>::Float;
    using I = typename Lanes<N>::Int;
    using M = typename Lanes<N>::Mask;

  public:
    PlaneSetup(const Frame& frame, TileBuffer& tile) : frame_(frame), tile_(tile) {}

    void run() {
        tile_.anchored_at_corners = true;
        const std::size_t size = N * plane_values(most_varyings());  // of a group
        float* const spare = place_groups(size);
        for (std::size_t first = 0; first < tile_.triangles.size(); first += N) {
            const std::uint32_t owners = owners_from(first);
            for (std::uint32_t left = owners; left != 0;) {
                const std::int32_t number = tile_.owns[first + lane_of(left)];
                const Shader& shader = frame_.shaders[static_cast<std::size_t>(number - 1)];
                const std::uint32_t mine = lane_bits(load<I>(&tile_.owns[first]) == I(number));
                float* const planes = &tile_.planes[start_of(first)];
                if (mine == owners) {
                    set_up_group(first, mine, shader, planes);
                } else {
                    set_up_group(first, mine, shader, spare);
                    copy_lanes(spare, size, mine, planes);
                }
                left &= ~mine;
            }
        }
    }

  private:
    int most_varyings() const {
        int most = 0;
        for (const Shader& shader : frame_.shaders) {
            most = std::max(most, shader.varyings);
        }
        return most;
    }
    // Room for each group with owners, and for one more, which is returned.
    float* place_groups(std::size_t size) {
        const std::size_t groups = (tile_.triangles.size() + N - 1) / N;
        tile_.plane_start.resize(groups);
        std::int32_t* const start = tile_.plane_start.data();
        std::size_t used = 0;
        for (std::size_t group = 0; group < groups; ++group) {
            start[group] = static_cast<std::int32_t>(used);
            used += owners_from(group * N) != 0 ? size : 0;
        }
        tile_.planes.resize(std::max(tile_.planes.size(), used + size));
        return &tile_.planes[used];
    }
    std::size_t start_of(std::size_t first) const {
        return static_cast<std::size_t>(tile_.plane_start[first / N]);
    }
    std::uint32_t owners_from(std::size_t first) const {
        return lane_bits(load<I>(&tile_.owns[first]) > I(0));
    }
    static std::size_t lane_of(std::uint32_t lanes) {
        return static_cast<std::size_t>(std::countr_zero(lanes));
    }

    static void copy_lanes(const float* from, std::size_t size, std::uint32_t lanes, float* to) {
        for (; lanes != 0; lanes &= lanes - 1) {
            for (std::size_t at = lane_of(lanes); at < size; at += N) {
                to[at] = from[at];
            }
        }
    }

    // Those of the N triangles from first on that own fragments and have this shader.
    void set_up_group(std::size_t first, std::uint32_t owners, const Shader& shader,
                      float* planes) {
        const std::uint32_t done = set_up_small(first, owners, shader, planes);
        for (std::uint32_t left = owners; left != 0; left &= left - 1) {
            const std::size_t lane = lane_of(left);
            const TileTriangle& t = tile_.triangles[first + lane];
            if ((done >> lane & 1U) == 0) {
                tile_.anchored_at_corners = false;
                set_up_large_planes(frame_, tile_, screen_triangle(frame_, t), shader, N,
                                    planes + lane);
            }
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
    Corners corners(std::size_t first, std::uint32_t owners) const {
        Corners c;
        for (; owners != 0; owners &= owners - 1) {
            const std::size_t lane = lane_of(owners);
            const TriangleRef ref = tile_.triangles[first + lane].ref;
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

    // What the planes of a group of small triangles are made of.
    struct Slopes {
        M one, two;       // corner 1, or else corner 2, comes first
        M steep, second;  // 1/w more than doubles; to the second of the others
        T weight[2];      // 1/w of the other two, in units of the first's
        T x[2], y[2];     // from the first to them, in 1/256 pixel
        T scale;          // 256 over the doubled area

        // Turns the values of the corners so that the first comes first.
        template <class V>
        void turn(V (&v)[3]) const {
            const V old[3] = {v[0], v[1], v[2]};
            for (int i = 0; i < 3; ++i) {
                v[i] = select(one, old[(i + 1) % 3], select(two, old[(i + 2) % 3], old[i]));
            }
        }
        // The slopes, a pixel right and a pixel down, of what rises so from the first to the
        // others. In a sliver the products nearly cancel.
        T dx(const T& rise1, const T& rise2) const {
            return difference_of_products(y[1], rise1, y[0], rise2) * scale;
        }
        T dy(const T& rise1, const T& rise2) const {
            return difference_of_products(x[0], rise2, x[1], rise1) * scale;
        }
    };

    // By varying, corner and lane.
    using GroupVaryings = std::array<float, 3 * N * max_varyings>;

    // Sets up the small triangles of a group; bit i says that it did lane i.
    std::uint32_t set_up_small(std::size_t first, std::uint32_t owners, const Shader& shader,
                               float* planes) {
        const Corners c = corners(first, owners);
        // Long before they are read, or the processor would wait until they are written.
        GroupVaryings varyings;
        shader.vertex(shader.shader, *frame_.mesh, c.vertex.data(), 3 * N, 3 * N, varyings.data());
        I x[3];
        I y[3];
        T s[3];
        for (std::size_t i = 0; i < 3; ++i) {
            const LaneVertices<N> v = load_vertices<N>(*frame_.vertices, &c.vertex[i * N]);
            x[i] = v.x;
            y[i] = v.y;
            s[i] = v.inverse_w;
        }
        // Anchored at the farthest: there S is smallest.
        Slopes slopes;
        slopes.one = (s[1] < s[0]) & (s[1] <= s[2]);
        slopes.two = (s[2] < s[0]) & (s[2] < s[1]);
        slopes.turn(x);
        slopes.turn(y);
        slopes.turn(s);
        slopes.second = s[2] > s[1];
        slopes.steep = max(s[1], s[2]) > T(2.0F) * s[0];
        const I width = max(max(x[0], x[1]), x[2]) - min(min(x[0], x[1]), x[2]);
        const I height = max(max(y[0], y[1]), y[2]) - min(min(y[0], y[1]), y[2]);
        const M small = (width < I(small_extent)) & (height < I(small_extent));
        const std::uint32_t done = lane_bits(small) & c.whole;
        if (done == 0) {
            return 0;
        }
        if ((lane_bits(slopes.steep) & done) != 0 && !shader.directions_only) {
            tile_.anchored_at_corners = false;
        }
        const I dx1 = select(small, x[1] - x[0], I(0));
        const I dy1 = select(small, y[1] - y[0], I(0));
        const I dx2 = select(small, x[2] - x[0], I(0));
        const I dy2 = select(small, y[2] - y[0], I(0));
        slopes.x[0] = to_float(dx1);
        slopes.x[1] = to_float(dx2);
        slopes.y[0] = to_float(dy1);
        slopes.y[1] = to_float(dy2);
        slopes.scale = T(static_cast<float>(subpixel_one)) / to_float(dx1 * dy2 - dx2 * dy1);
        const T unit = T(1.0F) / s[0];
        slopes.weight[0] = s[1] * unit;
        slopes.weight[1] = s[2] * unit;

        const T to_pixel(1.0F / static_cast<float>(subpixel_one));
        store(planes, to_float(x[0] - I(tile_.x * subpixel_one)) * to_pixel);
        store(planes + N, to_float(y[0] - I(tile_.y * subpixel_one)) * to_pixel);
        const T rise[2] = {(s[1] - s[0]) * unit, (s[2] - s[0]) * unit};
        store(planes + 2 * N, slopes.dx(rise[0], rise[1]));
        store(planes + 3 * N, slopes.dy(rise[0], rise[1]));
        store_varyings(varyings, shader, slopes, planes + 4 * N);
        return done;
    }

    static void store_varyings(const GroupVaryings& varyings, const Shader& shader,
                               const Slopes& slopes, float* planes) {
        const auto count = static_cast<std::size_t>(shader.varyings);
        for (std::size_t k = 0; k < count; ++k) {
            const float* of_corners = &varyings[3 * N * k];
            T corner[3] = {load<T>(of_corners), load<T>(of_corners + N),
                           load<T>(of_corners + 2 * N)};
            slopes.turn(corner);
            float* out = planes + k * N;
            if (shader.directions_only) {
                const T rise1 = corner[1] * slopes.weight[0] - corner[0];
                const T rise2 = corner[2] * slopes.weight[1] - corner[0];
                store(out, corner[0]);
                store(out + count * N, slopes.dx(rise1, rise2));
                store(out + 2 * count * N, slopes.dy(rise1, rise2));
                continue;
            }
            const T nearest = select(slopes.second, corner[2], corner[1]);
            const T first = select(slopes.steep, nearest, corner[0]);
            const T d0 = corner[0] - first;
            const T rise1 = (corner[1] - first) * slopes.weight[0] - d0;
            const T rise2 = (corner[2] - first) * slopes.weight[1] - d0;
            store(out, first);
            store(out + count * N, slopes.dx(rise1, rise2));
            store(out + 2 * count * N, slopes.dy(rise1, rise2));
            store(out + 3 * count * N, d0);
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
