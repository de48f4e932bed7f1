// Stage 1: vertices into window space.
#pragma once

#include "framework/raster/pipeline.hpp"

#include <cstddef>
#include <span>

namespace glint {

// Clip coordinates of a point: M (p, 1), each row summed from left to right.
template <class T>
Vec4<T> clip_position(const glm::mat4& m, const T& x, const T& y, const T& z) {
    Vec4<T> r;
    for (int row = 0; row < 4; ++row) {
        r[row] = T(m[0][row]) * x + T(m[1][row]) * y + T(m[2][row]) * z + T(m[3][row]);
    }
    return r;
}

// Window position in pixels, depth and 1/w of a clip position with w > 0.
template <class T>
struct WindowPosition {
    T x, y, z, inverse_w;
};
template <class T>
WindowPosition<T> window_position(const Vec4<T>& clip, const View& view) {
    const T half_width(0.5F * static_cast<float>(view.width));
    const T half_height(0.5F * static_cast<float>(view.height));
    const T inverse_w = T(1.0F) / clip.w;
    return {half_width + clip.x * inverse_w * half_width,
            half_height - clip.y * inverse_w * half_height, clip.z * inverse_w, inverse_w};
}

// w below this is not in front of the eye.
inline constexpr float smallest_w = 1e-30F;

// Fills places first..last of out, which is as long as positions already.
void transform(std::span<const glm::vec3> positions, const View& view, int lanes, std::size_t first,
               std::size_t last, VertexBuffer& out);

}  // namespace glint
