#include "framework/raster/transform.hpp"

#include "framework/raster/lane_vertices.hpp"
#include "framework/math/dispatch.hpp"

namespace glint {
namespace {

// Every comparison is false for NaN, so what is not finite asks for clipping, which drops it.
template <class T>
auto has_place(const Vec4<T>& clip, const WindowPosition<T>& window) {
    const T guard(static_cast<float>(guard_band));
    return (clip.w >= T(smallest_w)) & (clip.z <= clip.w) & (window.x >= -guard) &
           (window.x <= guard) & (window.y >= -guard) & (window.y <= guard);
}

// x, y and z of N points. N above 1: the memory goes on for a float behind them.
template <int N>
auto coordinates(const glm::vec3* points) {
    using T = typename Lanes<N>::Float;
    if constexpr (N == 1) {
        return Vec3<T>(*points);
    } else {
        const float* rows[N];
        for (std::size_t i = 0; i < N; ++i) {
            rows[i] = &points[i].x;
        }
        const auto columns = load_rows<T>(rows);
        return Vec3<T>(columns[0], columns[1], columns[2]);
    }
}

template <int N>
void transform_lanes(std::span<const glm::vec3> positions, const View& view, std::size_t i,
                     VertexBuffer& out) {
    using T = typename Lanes<N>::Float;
    using I = typename Lanes<N>::Int;
    const Vec3<T> p = coordinates<N>(&positions[i]);
    const Vec4<T> clip = clip_position(view.clip_from_world, p.x, p.y, p.z);
    const WindowPosition<T> window = window_position(clip, view);
    const MaskOf<T> placed = has_place(clip, window);
    const I x = select(placed, snap(select(placed, window.x, T(0.0F))), I(needs_clipping));
    const I y = snap(select(placed, window.y, T(0.0F)));
    store_vertices<N>(&out[i], {x, y, window.z, window.inverse_w});
}

}  // namespace

void transform(std::span<const glm::vec3> positions, const View& view, int lanes, std::size_t first,
               std::size_t last, VertexBuffer& out) {
    with_lanes(lanes, [&]<int N>() {
        std::size_t i = first;
        for (; i + N <= last && i + N < positions.size(); i += N) {
            transform_lanes<N>(positions, view, i, out);
        }
        for (; i < last; ++i) {
            transform_lanes<1>(positions, view, i, out);
        }
    });
}

}  // namespace glint
