// Vertices in window space, N at a time.
#pragma once

#include "framework/raster/pipeline.hpp"
#include "framework/math/lanes.hpp"

#include <cstddef>

namespace glint {

template <int N>
struct LaneVertices {
    typename Lanes<N>::Int x, y;
    typename Lanes<N>::Float z, inverse_w;
};

namespace lane_vertices_detail {
static_assert(sizeof(ScreenVertex) == 4 * sizeof(float));
inline const float* row(const ScreenVertex& v) {
    return reinterpret_cast<const float*>(&v);
}
}  // namespace lane_vertices_detail

// The vertices index[0], index[stride], ... index[(N - 1) stride]. Inlined, for what the caller
// does not use is then not made.
template <int N>
[[gnu::always_inline]] inline LaneVertices<N> load_vertices(const VertexBuffer& vertices,
                                                            const std::uint32_t* index,
                                                            std::size_t stride = 1) {
    const float* rows[N];
    for (std::size_t i = 0; i < N; ++i) {
        rows[i] = lane_vertices_detail::row(vertices[index[i * stride]]);
    }
    const auto columns = load_rows<typename Lanes<N>::Float>(rows);
    return {bits_of(columns[0]), bits_of(columns[1]), columns[2], columns[3]};
}

// Into N places side by side.
template <int N>
void store_vertices(ScreenVertex* to, const LaneVertices<N>& v) {
    store_rows(reinterpret_cast<float*>(to),
               Rows<typename Lanes<N>::Float>{float_from_bits(v.x), float_from_bits(v.y), v.z,
                                              v.inverse_w});
}

}  // namespace glint
